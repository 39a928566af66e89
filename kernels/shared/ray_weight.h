#ifndef LICHTRAUM_SHARED_RAY_WEIGHT_H
#define LICHTRAUM_SHARED_RAY_WEIGHT_H

/* Mirrored and refracted rays that can change a pixel by less than this share of what they see are not followed. */
#define MIN_RAY_WEIGHT 0.0009765625f

#endif
