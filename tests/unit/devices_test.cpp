#include "lichtraum/device.hpp"
#include "lichtraum/error.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

DeviceInfo device(int index, DeviceKind kind, std::string name) {
  DeviceInfo info;
  info.index = index;
  info.kind = kind;
  info.name = std::move(name);
  return info;
}

DeviceList three_devices() {
  return {{device(0, DeviceKind::gpu, "Fast Card 9000"), device(1, DeviceKind::cpu, "pthread-cpu"),
           device(2, DeviceKind::reference, "reference")},
          {}};
}

}  // namespace

TEST_CASE("a device is selected by index, kind or part of its name", "[unit][device]") {
  DeviceList const list = three_devices();
  CHECK(select_device(list, "").index == 0);
  CHECK(select_device(list, "1").index == 1);
  CHECK(select_device(list, "cpu").index == 1);
  CHECK(select_device(list, "GPU").index == 0);
  CHECK(select_device(list, "reference").index == 2);
  CHECK(select_device(list, "PTHREAD").index == 1);
}

TEST_CASE("an unknown device is refused with the list of those there are", "[unit][device]") {
  DeviceList const list = three_devices();
  for (char const* selector : {"3", "-1", "riva", "1x"}) {
    try {
      select_device(list, selector);
      FAIL("'" << selector << "' was accepted");
    } catch (Error const& error) {
      CHECK(error.kind() == ErrorKind::no_device);
      CHECK(std::string(error.what()).find("1  pthread-cpu") != std::string::npos);
    }
  }
}

TEST_CASE("of no devices none can be selected", "[unit][device]") {
  for (char const* selector : {"", "0"}) CHECK_THROWS_AS(select_device(DeviceList(), selector), Error);
}

TEST_CASE("the reference tracer is always there, and last", "[unit][device]") {
  DeviceList const list = find_devices();
  REQUIRE(!list.devices.empty());
  CHECK(list.devices.back().kind == DeviceKind::reference);
  for (std::size_t i = 0; i < list.devices.size(); ++i) CHECK(list.devices[i].index == int(i));
  CHECK((list.devices.size() > 1 || !list.warnings.empty()));  // without OpenCL it says why
}
