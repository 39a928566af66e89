#pragma once

#include <span>

#include "accel/bvh.hpp"

namespace lichtraum {

/// How many leaves a ray tests, in the mean, that enters the node of which this is the most: a few dozen for surfaces,
/// and as many as there are where all lie in one place. A ray that enters a node enters each box in it as likely as its
/// area is large in proportion (Goldsmith and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing",
/// 1987). `of_instances`: what one test of an instance stands for, by its number in the references. The hierarchy's
/// nodes must lie in depth-first order.
double crowding(Bvh const& bvh, std::span<double const> of_instances = {});

}  // namespace lichtraum
