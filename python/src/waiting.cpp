#include "waiting.hpp"

#include <atomic>
#include <chrono>
#include <future>

namespace nb = nanobind;

namespace lichtraum::python {

void wait_for(std::function<void(ProgressFunction const&)> const& work, nb::object const& show) {
  std::atomic<bool> stops = false;
  std::atomic<double> fraction = 0;
  ProgressFunction const progress = [&](RenderProgress const& now) {
    fraction = now.fraction;
    return !stops;
  };
  auto done = std::async(std::launch::async, [&] { work(progress); });
  auto const is_done_in = [&](std::chrono::milliseconds time) {
    nb::gil_scoped_release const release;
    return done.wait_for(time) == std::future_status::ready;
  };
  try {
    double shown = 0;
    while (!is_done_in(std::chrono::milliseconds(50))) {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (double const now = fraction; !show.is_none() && now > shown) show(shown = now);
    }
  } catch (...) {
    stops = true;
    nb::gil_scoped_release const release;
    done.wait();  // it uses what is above
    throw;
  }
  done.get();
}

}  // namespace lichtraum::python
