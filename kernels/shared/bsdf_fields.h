#ifndef LICHTRAUM_SHARED_BSDF_FIELDS_H
#define LICHTRAUM_SHARED_BSDF_FIELDS_H

/* What a point of a surface does with light, whatever its material's model: the parameters of bsdf/bsdf.clh, written
 * down once: COLOR(name), NUMBER(name). */
#define BSDF_FIELDS(COLOR, NUMBER)                                                                                   \
  COLOR(emission)                                                                                                    \
  NUMBER(opacity)                      /* the share of rays that meet the surface; the others go straight on */      \
  NUMBER(shows_back)                   /* 0: to the camera, what is seen from behind is not there */                 \
  COLOR(diffuse)                       /* reflectance of the matt lobe ... */                                        \
  COLOR(translucent)                   /* ... and what it lets through, to all directions of the other side */       \
  COLOR(f0)                            /* Fresnel's factor of the glossy lobe, seen head-on ... */                   \
  COLOR(f90)                           /* ... and at grazing angles */                                               \
  COLOR(metal)                         /* the same of a metal, head-on, which has no lobes below ... */              \
  NUMBER(metallic)                     /* ... and its share of the surface */                                        \
  NUMBER(alpha)                        /* its roughness ... */                                                       \
  NUMBER(stretch)                      /* ... times this along x, over it along y */                                 \
  NUMBER(is_layered)                   /* 1: what it reflects is lost to the lobes below it, and it loses nothing */ \
  COLOR(transmitted)                   /* what gets through of the light that the glossy lobe leaves */              \
  NUMBER(ior)                          /* that refracts it; 1: a thin wall */                                        \
  NUMBER(ior_spread)                   /* by which that of blue light is larger, of red smaller */                   \
  COLOR(attenuation_color)             /* of white light in a solid body ... */                                      \
  NUMBER(inverse_attenuation_distance) /* ... after 1 / this, in world units */                                      \
  NUMBER(mirror)                       /* shares of perfect mirror and glass */                                      \
  NUMBER(glass)                                                                                                      \
  NUMBER(coat) /* share of a clear coat above all of this, of index 1.5 */                                           \
  NUMBER(coat_alpha)                                                                                                 \
  COLOR(sheen) /* reflectance of the fibres of cloth, between the coat and the rest */                               \
  NUMBER(sheen_alpha)                                                                                                \
  NUMBER(film)           /* share of the glossy lobe that a thin film covers ... */                                  \
  NUMBER(film_ior)       /* of this index ... */                                                                     \
  NUMBER(film_thickness) /* and this many nm, above 0 where there is one */

#endif
