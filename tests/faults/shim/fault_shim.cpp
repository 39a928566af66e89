// Loaded before a program (LD_PRELOAD), makes the N-th call of a kind that the program makes fail, and counts them.
//
//   LICHTRAUM_FAULT_KIND   allocation, write, read, open, rename, sync, close, thread, process, opencl,
//                          map (of its buffers), or clock: the time of day is more than a year off, before or after
//   LICHTRAUM_FAULT_AT     which call fails, from 1; 0: none, they are counted
//   LICHTRAUM_FAULT_LASTS  1: all later calls of the kind fail, too, as on a disk that is full
//   LICHTRAUM_FAULT_CODE   instead of the usual errno, or OpenCL's status
//   LICHTRAUM_FAULT_COUNT  a file that gets the number of calls and of failures, as two 32-bit integers
//
// A call counts from the beginning of main, in the process that was started (not in its children), when the program
// itself makes it, or the C++ library for it: drivers and codecs may end a process whose memory they do not get.

#include <CL/cl.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>
#include <unwind.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

enum class Kind { none, allocation, write, read, open, rename, sync, close, thread, process, opencl, map, clock };
constexpr std::array kind_names{"none",  "allocation", "write",   "read",   "open", "rename", "sync",
                                "close", "thread",     "process", "opencl", "map",  "clock"};

/// Where a module's code lies.
struct Range {
  std::uintptr_t begin = 0, end = 0;
  bool has(std::uintptr_t address) const { return begin <= address && address < end; }
};

Kind kind = Kind::none;
int fails_at = 0;
bool lasts = false;
int code_given = 0;
pid_t counted_process = 0;
bool is_running = false;  // main has begun
struct Counts {
  std::atomic<std::int32_t> calls, failures;
};
Counts* counts = nullptr;
Range program, standard_library, shim;

int find_ranges(dl_phdr_info* info, std::size_t, void*) {
  Range code;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    auto const& part = info->dlpi_phdr[i];
    if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0) continue;
    code = {info->dlpi_addr + part.p_vaddr, info->dlpi_addr + part.p_vaddr + part.p_memsz};
  }
  if (info->dlpi_name[0] == '\0' && program.end == 0) program = code;  // the first is the program
  if (std::strstr(info->dlpi_name, "libstdc++")) standard_library = code;
  if (code.has(reinterpret_cast<std::uintptr_t>(&find_ranges))) shim = code;
  return 0;
}

char const* setting(char const* name) {
  char const* const value = std::getenv(name);
  return value ? value : "";
}

/// Children run without it.
__attribute__((constructor)) void begin() {
  char const* const wanted = setting("LICHTRAUM_FAULT_KIND");
  for (std::size_t i = 0; i < kind_names.size(); ++i) {
    if (std::strcmp(wanted, kind_names[i]) == 0) kind = Kind(i);
  }
  fails_at = std::atoi(setting("LICHTRAUM_FAULT_AT"));
  lasts = std::atoi(setting("LICHTRAUM_FAULT_LASTS")) != 0;
  code_given = std::atoi(setting("LICHTRAUM_FAULT_CODE"));
  counted_process = ::getpid();
  int const file = ::openat(AT_FDCWD, setting("LICHTRAUM_FAULT_COUNT"), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file >= 0 && ::ftruncate(file, sizeof(Counts)) == 0) {
    void* const shared = ::mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (shared != MAP_FAILED) counts = static_cast<Counts*>(shared);
  }
  dl_iterate_phdr(find_ranges, nullptr);
  for (char const* const name : {"LD_PRELOAD", "LICHTRAUM_FAULT_KIND"}) ::unsetenv(name);
}

_Unwind_Reason_Code look_at_caller(_Unwind_Context* context, void* result) {
  std::uintptr_t const address = _Unwind_GetIP(context);
  if (shim.has(address) || standard_library.has(address)) return _URC_NO_REASON;
  *static_cast<bool*>(result) = program.has(address);
  return _URC_END_OF_STACK;
}

/// Whether the program made the call that returns to `caller`, or the C++ library did for it.
bool is_of_program(void* caller) {
  auto const address = reinterpret_cast<std::uintptr_t>(caller);
  if (program.has(address)) return true;
  if (!standard_library.has(address) && !shim.has(address)) return false;
  static thread_local bool is_looking = false;
  if (is_looking) return false;
  is_looking = true;
  bool found = false;
  _Unwind_Backtrace(look_at_caller, &found);
  is_looking = false;
  return found;
}

/// Whether this call is to fail: then with the status that is returned, else 0.
int fault(Kind of, void* caller, int usual_code) {
  if (of != kind || !is_running || !counts || !is_of_program(caller) || ::getpid() != counted_process) return 0;
  int const number = ++counts->calls;
  if (fails_at == 0 || number < fails_at || (number > fails_at && !lasts)) return 0;
  ++counts->failures;
  return code_given != 0 ? code_given : usual_code;
}

/// Of the time of day, differently each time.
time_t seconds_off(void* caller) {
  constexpr time_t year = 366 * 24 * 60 * 60;
  if (fault(Kind::clock, caller, 1) == 0) return 0;
  return counts->calls % 2 == 0 ? year : -year;
}

template <class Function>
Function* next(Function*, char const* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

/// What operator new does then; a handler cannot find any memory here.
[[noreturn]] void lack() {
  if (auto const handler = std::get_new_handler()) handler();
  throw std::bad_alloc();
}

template <class Value>
Value failed(int code, Value value) {
  errno = code;
  return value;
}

}  // namespace

#define CALLER __builtin_return_address(0)
// The function of that name which this one stands before.
#define NEXT(name)                                     \
  (*[] {                                               \
    static auto const function = next(&::name, #name); \
    return function;                                   \
  }())

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*rtld_fini)(), void* stack_end) {
  static int (*program_main)(int, char**, char**) = main;
  auto const counted_main = [](int count, char** values, char** environment) {
    is_running = true;
    int const status = program_main(count, values, environment);
    is_running = false;
    return status;
  };
  using Start = int(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
  auto* const start = reinterpret_cast<Start*>(::dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

void* malloc(std::size_t size) {
  if (int const code = fault(Kind::allocation, CALLER, ENOMEM)) return failed<void*>(code, nullptr);
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  if (int const code = fault(Kind::allocation, CALLER, ENOMEM)) return failed<void*>(code, nullptr);
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  if (int const code = fault(Kind::allocation, CALLER, ENOMEM)) return failed<void*>(code, nullptr);
  return __libc_realloc(old, size);
}

ssize_t write(int file, void const* bytes, std::size_t count) {
  if (int const code = fault(Kind::write, CALLER, ENOSPC)) return failed(code, ssize_t(-1));
  return NEXT(write)(file, bytes, count);
}
ssize_t writev(int file, iovec const* parts, int count) {
  if (int const code = fault(Kind::write, CALLER, ENOSPC)) return failed(code, ssize_t(-1));
  return NEXT(writev)(file, parts, count);
}
ssize_t read(int file, void* bytes, std::size_t count) {
  if (int const code = fault(Kind::read, CALLER, EIO)) return failed(code, ssize_t(-1));
  return NEXT(read)(file, bytes, count);
}
int open(char const* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  mode_t const mode = va_arg(rest, mode_t);
  va_end(rest);
  if (int const code = fault(Kind::open, CALLER, EMFILE)) return failed(code, -1);
  return ::openat(AT_FDCWD, path, flags, mode);
}
int open64(char const* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  mode_t const mode = va_arg(rest, mode_t);
  va_end(rest);
  if (int const code = fault(Kind::open, CALLER, EMFILE)) return failed(code, -1);
  return ::openat(AT_FDCWD, path, flags, mode);
}
FILE* fopen(char const* path, char const* mode) {
  if (int const code = fault(Kind::open, CALLER, EMFILE)) return failed<FILE*>(code, nullptr);
  return NEXT(fopen)(path, mode);
}
FILE* fopen64(char const* path, char const* mode) {
  if (int const code = fault(Kind::open, CALLER, EMFILE)) return failed<FILE*>(code, nullptr);
  return NEXT(fopen64)(path, mode);
}
int rename(char const* from, char const* to) noexcept {
  if (int const code = fault(Kind::rename, CALLER, EIO)) return failed(code, -1);
  return NEXT(rename)(from, to);
}
int link(char const* from, char const* to) noexcept {
  if (int const code = fault(Kind::rename, CALLER, EIO)) return failed(code, -1);
  return NEXT(link)(from, to);
}
int fsync(int file) {
  if (int const code = fault(Kind::sync, CALLER, EIO)) return failed(code, -1);
  return NEXT(fsync)(file);
}
/// The file is closed, but what was written before is lost, as network file systems report it.
int close(int file) {
  int const code = fault(Kind::close, CALLER, EDQUOT);
  int const result = NEXT(close)(file);
  return code != 0 ? failed(code, -1) : result;
}
// Steady clocks do not jump, and are left alone.
int clock_gettime(clockid_t clock, timespec* now) noexcept {
  int const result = NEXT(clock_gettime)(clock, now);
  if (clock == CLOCK_REALTIME) now->tv_sec += seconds_off(CALLER);
  return result;
}
int gettimeofday(timeval* now, void* zone) noexcept {
  int const result = NEXT(gettimeofday)(now, zone);
  now->tv_sec += seconds_off(CALLER);
  return result;
}
time_t time(time_t* now) noexcept {
  time_t const result = NEXT(time)(nullptr) + seconds_off(CALLER);
  if (now) *now = result;
  return result;
}
int pthread_create(pthread_t* thread, pthread_attr_t const* attributes, void* (*work)(void*), void* argument) {
  if (int const code = fault(Kind::thread, CALLER, EAGAIN)) return code;
  return NEXT(pthread_create)(thread, attributes, work, argument);
}
int posix_spawn(pid_t* child, char const* path, posix_spawn_file_actions_t const* actions,
                posix_spawnattr_t const* attributes, char* const* arguments, char* const* environment) {
  if (int const code = fault(Kind::process, CALLER, EAGAIN)) return code;
  return NEXT(posix_spawn)(child, path, actions, attributes, arguments, environment);
}
pid_t fork() noexcept {
  if (int const code = fault(Kind::process, CALLER, EAGAIN)) return failed(code, -1);
  return NEXT(fork)();
}
int pipe(int* ends) noexcept {
  if (int const code = fault(Kind::process, CALLER, EMFILE)) return failed(code, -1);
  return NEXT(pipe)(ends);
}
int pipe2(int* ends, int flags) noexcept {
  if (int const code = fault(Kind::process, CALLER, EMFILE)) return failed(code, -1);
  return NEXT(pipe2)(ends, flags);
}
int memfd_create(char const* name, unsigned flags) noexcept {
  if (int const code = fault(Kind::process, CALLER, EMFILE)) return failed(code, -1);
  return NEXT(memfd_create)(name, flags);
}

/// Where it fails nothing runs any longer, as on a device that was lost.
cl_int CL_API_CALL clFinish(cl_command_queue queue) {
  int const code = fault(Kind::opencl, CALLER, CL_OUT_OF_RESOURCES);
  int const status = NEXT(clFinish)(queue);
  return code != 0 ? code : status;
}

// What fails with a status, and what gives nothing and puts the status where its last argument says.
#define OPENCL_STATUS(name, parameters, arguments)                                      \
  cl_int CL_API_CALL name parameters {                                                  \
    if (int const code = fault(Kind::opencl, CALLER, CL_OUT_OF_RESOURCES)) return code; \
    return NEXT(name) arguments;                                                        \
  }
#define OPENCL_THING(type, name, parameters, arguments)                        \
  type CL_API_CALL name parameters {                                           \
    if (int const code = fault(Kind::opencl, CALLER, CL_OUT_OF_HOST_MEMORY)) { \
      if (status) *status = code;                                              \
      return nullptr;                                                          \
    }                                                                          \
    return NEXT(name) arguments;                                               \
  }

OPENCL_STATUS(clGetPlatformIDs, (cl_uint n, cl_platform_id* found, cl_uint* count), (n, found, count))
OPENCL_STATUS(clGetDeviceIDs, (cl_platform_id p, cl_device_type type, cl_uint n, cl_device_id* found, cl_uint* count),
              (p, type, n, found, count))
OPENCL_STATUS(clGetPlatformInfo, (cl_platform_id p, cl_platform_info what, size_t n, void* value, size_t* size),
              (p, what, n, value, size))
OPENCL_STATUS(clGetDeviceInfo, (cl_device_id d, cl_device_info what, size_t n, void* value, size_t* size),
              (d, what, n, value, size))
OPENCL_STATUS(clBuildProgram,
              (cl_program p, cl_uint n, cl_device_id const* devices, char const* options,
               void(CL_CALLBACK* done)(cl_program, void*), void* argument),
              (p, n, devices, options, done, argument))
OPENCL_STATUS(clGetProgramBuildInfo,
              (cl_program p, cl_device_id d, cl_program_build_info what, size_t n, void* value, size_t* size),
              (p, d, what, n, value, size))
OPENCL_STATUS(clSetKernelArg, (cl_kernel k, cl_uint i, size_t n, void const* value), (k, i, n, value))
OPENCL_STATUS(clEnqueueNDRangeKernel,
              (cl_command_queue q, cl_kernel k, cl_uint n, size_t const* offset, size_t const* global,
               size_t const* local, cl_uint before, cl_event const* events, cl_event* event),
              (q, k, n, offset, global, local, before, events, event))
OPENCL_STATUS(clEnqueueUnmapMemObject,
              (cl_command_queue q, cl_mem m, void* mapped, cl_uint before, cl_event const* events, cl_event* event),
              (q, m, mapped, before, events, event))
OPENCL_THING(cl_context, clCreateContext,
             (cl_context_properties const* properties, cl_uint n, cl_device_id const* devices,
              void(CL_CALLBACK* tell)(char const*, void const*, size_t, void*), void* argument, cl_int* status),
             (properties, n, devices, tell, argument, status))
OPENCL_THING(cl_command_queue, clCreateCommandQueue,
             (cl_context c, cl_device_id d, cl_command_queue_properties properties, cl_int* status),
             (c, d, properties, status))
OPENCL_THING(cl_mem, clCreateBuffer, (cl_context c, cl_mem_flags flags, size_t n, void* host, cl_int* status),
             (c, flags, n, host, status))
OPENCL_THING(cl_program, clCreateProgramWithSource,
             (cl_context c, cl_uint n, char const** texts, size_t const* lengths, cl_int* status),
             (c, n, texts, lengths, status))
OPENCL_THING(cl_program, clCreateProgramWithBinary,
             (cl_context c, cl_uint n, cl_device_id const* devices, size_t const* lengths, unsigned char const** bytes,
              cl_int* each, cl_int* status),
             (c, n, devices, lengths, bytes, each, status))
OPENCL_THING(cl_kernel, clCreateKernel, (cl_program p, char const* name, cl_int* status), (p, name, status))
/// A kind of its own, too: what was launched before may be running when it fails.
void* CL_API_CALL clEnqueueMapBuffer(cl_command_queue queue, cl_mem buffer, cl_bool waits, cl_map_flags flags,
                                     size_t offset, size_t size, cl_uint before, cl_event const* events,
                                     cl_event* event, cl_int* status) {
  int code = fault(Kind::opencl, CALLER, CL_OUT_OF_HOST_MEMORY);
  if (code == 0) code = fault(Kind::map, CALLER, CL_OUT_OF_HOST_MEMORY);
  if (code == 0)
    return NEXT(clEnqueueMapBuffer)(queue, buffer, waits, flags, offset, size, before, events, event, status);
  if (status) *status = code;
  return nullptr;
}

}  // extern "C"

void* operator new(std::size_t size) {
  if (fault(Kind::allocation, CALLER, ENOMEM) != 0) lack();
  void* const memory = __libc_malloc(size);
  if (!memory) lack();
  return memory;
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  if (fault(Kind::allocation, CALLER, ENOMEM) != 0) lack();
  void* const memory = __libc_memalign(std::size_t(alignment), size);
  if (!memory) lack();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
