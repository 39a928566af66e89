#ifndef LICHTRAUM_SHARED_PACKET_H
#define LICHTRAUM_SHARED_PACKET_H

/* A packet is a square of this many rays a side (pixels of a picture), in groups of one vector each. */
#define PACKET_SIDE 8
#define PACKET_LANES 16
#define PACKET_GROUP_SIDE 4
#define PACKET_GROUPS 4

#endif
