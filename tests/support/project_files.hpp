#pragma once

#include <string>

/// Where a file or folder of this project is, as in project_path("docs/JSON.md").
std::string project_path(std::string const& name);

/// All that is in a file of this project.
std::string read_project_file(std::string const& name);

/// Where a test leaves what is worth looking at. Its folder may be missing.
std::string artifact_path(std::string const& name);
