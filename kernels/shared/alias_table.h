#ifndef LICHTRAUM_SHARED_ALIAS_TABLE_H
#define LICHTRAUM_SHARED_ALIAS_TABLE_H

#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

/* Of a table that chooses one of n with given probabilities in constant time (Walker 1974, Vose 1991): of n equal parts
 * of 0..1 each belongs to its own number first, the rest of it to another. */
typedef struct {
  float share; /* of the part that is its own: 0..1 */
  uint other;  /* whose the rest is */
} AliasEntry;
DEVICE_STRUCT_SIZE(AliasEntry, 8);

DEVICE_NAMESPACE_END

#endif
