#pragma once

/// Of a namespace: what it declares is the library's interface, and can be linked to from outside. All else is hidden.
#define LICHTRAUM_API [[gnu::visibility("default")]]
