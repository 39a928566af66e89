#ifndef LICHTRAUM_SHARED_INTEGRATORS_H
#define LICHTRAUM_SHARED_INTEGRATORS_H

/* Ways to find the radiance along the camera's rays: INTEGRATOR(name). From this list the host has its enumeration
 * (include/lichtraum/renderer.hpp). On the device each is a function trace_<name>, which render.cl includes; a program
 * is compiled with one of them (program.clh).
 *
 *   path     all light, by chance: Kajiya, "The Rendering Equation" (1986)
 *   whitted  direct light, mirrors and glass: Whitted, "An Improved Illumination Model for Shaded Display" (1980) */
#define INTEGRATORS(INTEGRATOR) INTEGRATOR(whitted) INTEGRATOR(path)

#endif
