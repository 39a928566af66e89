/* Stands for Open Image Denoise: half of "color" becomes "output". The environment variable FAKE_OIDN makes it fail:
 * "version", "device" (it cannot be used here) or "memory" (while it filters). Compiled with LACKS_A_FUNCTION, one is
 * missing. */
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  char const* message;
  int error;
} Device;

typedef struct {
  Device* device;
  float const* color;
  float* output;
  size_t count;
} Filter;

static bool is_to_fail(char const* how) {
  char const* const wanted = getenv("FAKE_OIDN");
  return wanted && strcmp(wanted, how) == 0;
}

Device* oidnNewDevice(int type) { return type == 1 ? calloc(1, sizeof(Device)) : NULL; }
void oidnReleaseDevice(Device* device) { free(device); }
void oidnSetDeviceBool(Device* device, char const* name, bool value) { (void)device, (void)name, (void)value; }
int oidnGetDeviceInt(Device* device, char const* name) {
  (void)device;
  if (strcmp(name, "versionMajor") == 0) return is_to_fail("version") ? 3 : 2;
  return strcmp(name, "versionMinor") == 0 ? 7 : 9;
}
void oidnCommitDevice(Device* device) {
  if (!is_to_fail("device")) return;
  device->error = 5;
  device->message = "unsupported hardware";
}
int oidnGetDeviceError(Device* device, char const** message) {
  if (!device) return 0;
  int const error = device->error;
  *message = device->message;
  device->error = 0;
  return error;
}
Filter* oidnNewFilter(Device* device, char const* type) {
  if (strcmp(type, "RT") != 0) return NULL;
  Filter* const filter = calloc(1, sizeof(Filter));
  filter->device = device;
  return filter;
}
void oidnReleaseFilter(Filter* filter) { free(filter); }
void oidnSetSharedFilterImage(Filter* filter, char const* name, void* pixels, int format, size_t width, size_t height,
                              size_t offset, size_t pixel_stride, size_t row_stride) {
  if (format != 3 || offset || pixel_stride || row_stride) abort();
  filter->count = 3 * width * height;
  if (strcmp(name, "color") == 0) filter->color = pixels;
  if (strcmp(name, "output") == 0) filter->output = pixels;
}
void oidnSetFilterBool(Filter* filter, char const* name, bool value) { (void)filter, (void)name, (void)value; }
void oidnCommitFilter(Filter* filter) { (void)filter; }
#ifndef LACKS_A_FUNCTION
void oidnExecuteFilter(Filter* filter) {
  if (is_to_fail("memory")) {
    filter->device->error = 4;
    filter->device->message = "out of memory";
    return;
  }
  for (size_t i = 0; filter->color && i < filter->count; ++i) filter->output[i] = 0.5f * filter->color[i];
}
#endif
