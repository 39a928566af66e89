#ifndef LICHTRAUM_SHARED_PHONG_FIELDS_H
#define LICHTRAUM_SHARED_PHONG_FIELDS_H

/* The coefficients of Phong's model, written down once. From these lists come PhongModel (lichtraum/phong_model.hpp),
 * PhongMaterial and Phong of the device, what eSDF reads and operator<< prints, and the window's sliders.
 *
 *   COLOR(name, initial)                linear red, green and blue
 *   SHARE(name, initial)                of the light, 0..1
 *   NUMBER(name, initial, least, most)  in the range that a slider offers
 */

/* What every material of a course's scene has. */
#define PHONG_STANDARD_FIELDS(COLOR, SHARE, NUMBER) \
  COLOR(ka, 0.8)        /* ambient reflectance */   \
  COLOR(kd, 0.8)        /* diffuse reflectance */   \
  COLOR(ks, 0)          /* specular reflectance */  \
  NUMBER(m, 1, 0, 1000) /* specular exponent, >= 0 */

/* What it may have besides; in eSDF, shares and numbers are keys: reflect=0.5; colours words: emission 4 4 3. */
#define PHONG_OPTIONAL_FIELDS(COLOR, SHARE, NUMBER)   \
  SHARE(reflect, 0)    /* of the mirror ray */        \
  SHARE(transmit, 0)   /* of the refracted ray */     \
  NUMBER(ior, 1, 1, 3) /* index of refraction, > 0 */ \
  COLOR(emission, 0)   /* sent out, whatever light arrives */

#define PHONG_FIELDS(COLOR, SHARE, NUMBER) \
  PHONG_STANDARD_FIELDS(COLOR, SHARE, NUMBER) PHONG_OPTIONAL_FIELDS(COLOR, SHARE, NUMBER)

#endif
