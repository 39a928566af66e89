/* An OpenCL platform that aborts its process when it is asked for, as PoCL does where it cannot read /sys. */
#include <stdio.h>
#include <stdlib.h>

int clIcdGetPlatformIDsKHR(unsigned count, void** platforms, unsigned* found) {
  (void)count, (void)platforms, (void)found;
  fprintf(stderr, "This platform does not want to live.\n");
  abort();
}

void* clGetExtensionFunctionAddress(char const* name) {
  (void)name;
  return (void*)clIcdGetPlatformIDsKHR;
}
