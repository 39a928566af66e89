#include "support/project_files.hpp"

#include "support/file_contents.hpp"

std::string project_path(std::string const& name) { return LICHTRAUM_SOURCE_DIR "/" + name; }

std::string read_project_file(std::string const& name) { return file_contents(project_path(name)); }

std::string artifact_path(std::string const& name) { return LICHTRAUM_ARTIFACT_DIR "/" + name; }
