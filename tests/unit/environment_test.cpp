#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "compile/alias_table.hpp"
#include "compile/environment_table.hpp"
#include "compile/scene_buffers.hpp"
#include "lichtraum/error.hpp"
#include "scene/flatten.hpp"
#include "scene/studio_environment.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;

namespace {

constexpr double pi = std::numbers::pi;

/// How probable each is that a table chooses.
std::vector<double> probabilities(std::vector<device::AliasEntry> const& table) {
  std::vector<double> result(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    result[i] += double(table[i].share) / double(table.size());
    result.at(table[i].other) += (1 - double(table[i].share)) / double(table.size());
  }
  return result;
}

std::vector<double> chosen_by(std::vector<double> const& weights) {
  std::vector<device::AliasEntry> table(weights.size());
  AliasTableMaker().fill(weights, table);
  return probabilities(table);
}

std::shared_ptr<EnvironmentMap const> one_value(int width, int height, float value) {
  auto map = std::make_shared<EnvironmentMap>(EnvironmentMap{width, height, {}});
  map->radiance.assign(3 * std::size_t(width * height), value);
  return map;
}

std::shared_ptr<EnvironmentMap const> random_map(int width, int height) {
  std::mt19937 random(3);
  auto map = std::make_shared<EnvironmentMap>(EnvironmentMap{width, height, {}});
  for (int i = 0; i < 3 * width * height; ++i) map->radiance.push_back(float(random() % 1000));
  return map;
}

double pdf_integral(EnvironmentTable const& table) {
  double sum = 0;
  int const width = table.map->width, height = table.map->height;
  for (int row = 0; row < height; ++row) {
    double const solid_angle = 2 * pi / width * (std::cos(pi * row / height) - std::cos(pi * (row + 1) / height));
    for (int i = 0; i < width; ++i) {
      sum += solid_angle * double(table.environment_densities[std::size_t(row * width + i)]);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("an alias table chooses by the weights that it was made of", "[unit][environment]") {
  std::mt19937 random(4);
  for (std::size_t const count : {1u, 2u, 3u, 17u, 1000u}) {
    for (int const kind : {0, 1, 2}) {
      std::vector<double> weights(count);
      for (double& weight : weights) {
        weight = kind == 0 ? 1 : kind == 1 ? double(random() % 100) : std::ldexp(1.0, int(random() % 200) - 100);
      }
      weights[count / 2] = kind == 1 ? 1e9 : 1;
      double const sum = std::accumulate(weights.begin(), weights.end(), 0.0);
      std::vector<double> const found = chosen_by(weights);
      for (std::size_t i = 0; i < count; ++i) {
        INFO(count << ", kind " << kind << ", " << i);
        if (std::abs(found[i] - weights[i] / sum) > 1e-7) FAIL("probability");
        if (weights[i] == 0 && found[i] != 0) FAIL("chosen");
      }
    }
  }
  CHECK(chosen_by({0, 0, 5, 0}) == std::vector<double>{0, 0, 1, 0});
  CHECK(chosen_by({0, 0}) == std::vector<double>{0.5, 0.5});
}

TEST_CASE("an environment's light on a level surface is that from above", "[unit][environment]") {
  CHECK(make_environment_table(one_value(8, 4, 3)).on_level.r == Approx(3).epsilon(1e-4));
  CHECK(make_environment_table(one_value(3, 1, 2)).on_level.b == Approx(2).epsilon(1e-3));
  // cos(theta)^2 from above, and far more from below, which does not count: 2 * the integral of cos^3 sin is 1/2.
  auto map = std::make_shared<EnvironmentMap>(EnvironmentMap{4, 256, {}});
  for (int row = 0; row < map->height; ++row) {
    double const cosine = std::cos(pi * (row + 0.5) / map->height);
    double const radiance = cosine > 0 ? cosine * cosine : 50;
    for (int column = 0; column < map->width; ++column) {
      for (double const channel : {1.0, 2.0, 0.0}) {
        map->radiance.push_back(float(2 * radiance * channel * (cosine > 0 && column % 2 == 1 ? 0 : 1)));
      }
    }
  }
  Rgb const on_level = make_environment_table(map).on_level;
  CHECK(on_level.r == Approx(0.5).epsilon(2e-3));
  CHECK(on_level.g == Approx(1).epsilon(2e-3));
  CHECK(on_level.b == 0);
}

TEST_CASE("an environment's table has densities, and its light's power", "[unit][environment]") {
  for (bool const is_compensated : {false, true}) {
    for (auto const& map : {random_map(40, 20), random_map(3, 1), studio_environment()}) {
      EnvironmentTable const table = make_environment_table(map, is_compensated);
      CHECK(pdf_integral(table) == Approx(1).epsilon(1e-6));
      double const low = *std::min_element(table.environment_densities.begin(), table.environment_densities.end());
      CHECK((low == 0) == is_compensated);
      CHECK(table.sampled_mean_luminance > 0);
      CHECK((table.sampled_mean_luminance < 0.9 * table.mean_luminance) == is_compensated);
    }
    EnvironmentTable const constant = make_environment_table(one_value(64, 32, 0.3f), is_compensated);
    CHECK(constant.mean_luminance == Approx(0.3));
    CHECK(pdf_integral(constant) == Approx(is_compensated ? 0 : 1).margin(1e-6));
    EnvironmentTable const black = make_environment_table(one_value(64, 32, 0), is_compensated);
    CHECK(black.mean_luminance == 0);
    CHECK(pdf_integral(black) == 0);
    // As bright and as dim as floats are: no infinite number, and none that is not a number.
    for (float const value : {3e38f, 1e-44f}) {
      auto bright = std::make_shared<EnvironmentMap>(*one_value(64, 32, 0));
      bright->radiance[3 * 700] = value;
      EnvironmentTable const table = make_environment_table(bright, is_compensated);
      device::SceneConstants constants{};
      set_environment(constants, table, {"", bright, 1e300, 1e30}, {0, 1, 0});
      CHECK(std::isfinite(constants.environment_power));
      CHECK(std::abs(constants.map_from_world[0][0]) <= 1);
      CHECK(std::all_of(table.environment_densities.begin(), table.environment_densities.end(),
                        [](float density) { return std::isfinite(density) && density >= 0; }));
    }
  }
}

TEST_CASE("an environment upside down has its densities upside down", "[unit][environment]") {
  for (auto const& map : {random_map(40, 20), random_map(8, 2)}) {
    EnvironmentMap flipped = *map;
    std::size_t const row = 3 * std::size_t(map->width), end = map->radiance.size();
    for (std::size_t i = 0; i < end; i += row) {
      std::copy_n(&map->radiance[i], row, &flipped.radiance[end - row - i]);
    }
    auto const upright = make_environment_table(map, false).environment_densities;
    auto const turned =
        make_environment_table(std::make_shared<EnvironmentMap const>(flipped), false).environment_densities;
    REQUIRE(upright.size() == std::size_t(map->width) * std::size_t(map->height));
    for (std::size_t i = 0; i < upright.size(); ++i) {
      std::size_t const texels = row / 3;
      REQUIRE(turned[upright.size() - texels - i / texels * texels + i % texels] == Approx(upright[i]).epsilon(1e-5));
    }
  }
}

TEST_CASE("edits turn an environment without a look at its map", "[unit][environment][edits]") {
  Scene scene;
  scene.environment = EnvironmentLight{"sky", random_map(16, 8), 0, 1};
  SceneBuffers const buffers =
      compile_scene(flatten(scene.roots()), scene.lights, TreeLayout::wide, nullptr, scene.environment);
  CHECK((buffers.shading.features & SCENE_ENVIRONMENT) != 0);
  device::SceneConstants const before = scene_constants(buffers, buffers.shading);
  SceneEdits edits;
  edits.environment = scene.environment;
  edits.environment->rotation_degrees = 90;
  edits.environment->brightness = 3;
  ShadingTables const turned = edit_tables(buffers, {}, edits);
  CHECK(turned.environment_table == buffers.shading.environment_table);
  device::SceneConstants const after = scene_constants(buffers, turned);
  CHECK(before.map_from_world[2][0] == 0);
  CHECK(after.map_from_world[2][0] == Approx(1));
  CHECK(after.environment_power == Approx(3 * double(before.environment_power)));

  edits.environment->map = random_map(8, 4);
  ShadingTables const other = edit_tables(buffers, {}, edits);
  CHECK(other.environment_table != buffers.shading.environment_table);
  CHECK(scene_constants(buffers, other).environment_width == 8);
  edits.environment.reset();
  ShadingTables const none = edit_tables(buffers, {}, edits);
  CHECK((none.features & SCENE_ENVIRONMENT) == 0);
  CHECK(none.environment_table->environment_texels.empty());
  CHECK(scene_constants(buffers, none).environment_power == 0);

  // The next picture of a sequence has the table that is there.
  SceneBuffers const next =
      compile_scene(flatten(scene.roots()), scene.lights, TreeLayout::wide, &buffers, scene.environment);
  CHECK(next.shading.environment_table == buffers.shading.environment_table);
}

TEST_CASE("the studio is neutral, smooth and as bright as a picture of a product wants", "[unit][environment]") {
  auto const map = studio_environment();
  REQUIRE(map->width == 1024);
  REQUIRE(map->height == 512);
  CHECK(make_environment_table(map).mean_luminance == Approx(0.7).margin(1e-3));
  auto const at = [&](int column, int row) {
    return map->radiance[3 * std::size_t(row * 1024 + (column + 1024) % 1024)];
  };
  float brightest = 0, steepest = 0;
  for (int row = 0; row < 512; ++row) {
    for (int column = 0; column < 1024; ++column) {
      float const value = at(column, row);
      std::size_t const texel = 3 * std::size_t(row * 1024 + column);
      if (!(value > 0) || map->radiance[texel + 1] != value || map->radiance[texel + 2] != value) FAIL("not neutral");
      brightest = std::max(brightest, value);
      steepest = std::max(steepest, std::abs(value - at(column - 1, row)));
      if (row > 0) steepest = std::max(steepest, std::abs(value - at(column, row - 1)));
    }
  }
  CHECK(brightest < 10);
  CHECK(steepest < 0.05f * brightest);
  // What white matt surfaces reflect. Who looks along -z sees the key on the upper left.
  auto const lit = [&](Vec3 const& normal) {
    double sum = 0;
    for (int row = 0; row < 512; ++row) {
      double const theta = pi * (row + 0.5) / 512;
      for (int column = 0; column < 1024; ++column) {
        double const phi = 2 * pi * ((column + 0.5) / 1024 - 0.5);
        Vec3 const d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
        sum += double(at(column, row)) * std::max(0.0, glm::dot(normal, d)) * std::sin(theta);
      }
    }
    return sum * 2 * pi / 1024 * pi / 512 / pi;
  };
  double const front = lit({0, 0, 1}), left = lit({-1, 0, 0}), right = lit({1, 0, 0});
  CHECK(front > 0.6);
  CHECK(front < 1);
  CHECK(left > 1.4 * right);
  CHECK(right > 0.3);
  CHECK(lit({0, 1, 0}) > 2 * lit({0, -1, 0}));
  CHECK(lit({0, -1, 0}) > 0.1);
}

TEST_CASE("what is chosen goes before the scene's environment", "[unit][environment]") {
  EnvironmentLight const own{"own", one_value(2, 1, 1), 30, 2};
  std::string asked;
  auto const other = one_value(4, 2, 1);
  auto const choose = [&](EnvironmentChoice const& choice, std::optional<EnvironmentLight> const& from) {
    return chosen_environment(choice, from, [&](std::string const& source) {
      asked += source;
      return other;
    });
  };
  CHECK(choose({}, own)->map == own.map);
  CHECK(choose({}, own)->rotation_degrees == 30);
  CHECK(!choose({}, std::nullopt));
  CHECK(!choose({"none", {}, 3}, own));
  CHECK(!choose({"", 10, 3}, std::nullopt));
  auto const turned = choose({"", 10, {}}, own);
  CHECK(turned->map == own.map);
  CHECK(turned->rotation_degrees == 10);
  CHECK(turned->brightness == 2);
  CHECK(asked.empty());
  auto const exchanged = choose({"sky.hdr", {}, 5}, own);
  CHECK(asked == "sky.hdr");
  CHECK(exchanged->map == other);
  CHECK(exchanged->source == "sky.hdr");
  CHECK(exchanged->rotation_degrees == 0);
  CHECK(exchanged->brightness == 5);
  CHECK(environment_map("studio")->width == 1024);
  CHECK_THROWS_AS(environment_map("/nowhere/studio"), Error);
}
