#include <cstddef>
#include <vector>

#include "shared/bvh.h"
#include "shared/denoise.h"
#include "shared/film.h"
#include "shared/frame.h"
#include "shared/geometry.h"
#include "shared/pbr_material.h"
#include "shared/phong_from_pbr.h"
#include "shared/sampling.h"
#include "shared/scene_arrays.h"
#include "shared/texture.h"
#include "shared/vertex.h"
#include "shared/wide.h"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using lichtraum::device::uint;
using lichtraum::test::out;
using lichtraum::test::ProbeProgram;

TEST_CASE("Host and device agree on sizes and offsets of shared structs", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  std::vector<uint> expected;
  std::vector<std::string> names;
#define STRUCT(type)                                         \
  expected.push_back(uint(sizeof(lichtraum::device::type))); \
  names.push_back("sizeof " #type);
#define MEMBER(type, member)                                           \
  expected.push_back(uint(offsetof(lichtraum::device::type, member))); \
  names.push_back(#type "." #member);
#include "struct_members.h"

  std::vector<uint> sizes(expected.size());
  ProbeProgram("struct_sizes.cl").run("probe_struct_sizes", 1, {out(sizes)});
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    INFO(names[i]);
    CHECK(sizes[i] == expected[i]);
  }
}
