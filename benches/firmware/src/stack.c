/* Every function of the headers, of which the compiler writes the stack; and every type that a program holds, as an
 * array of its bytes. It is compiled and not linked. */
#include "luminaire_constant.h"
#include "luminaire_display.h"

#define BYTES(type) const char bytes_of_##type[sizeof(type)] = { 0 }

BYTES(luminaire_spot);
BYTES(luminaire_cone);
BYTES(luminaire_rgb);
BYTES(luminaire_row);
BYTES(luminaire_vertex);
BYTES(luminaire_palette);
BYTES(luminaire_packer);
BYTES(luminaire_strip);

/* What must be inlined has a function of its own only where its address is taken. */
uint32_t (*const irradiance)(const luminaire_spot *, const int32_t *, const int16_t *) = luminaire_spot_irradiance;
uint32_t (*const pixel)(uint32_t, luminaire_rgb) = luminaire_pixel;
uint32_t (*const dithered)(uint32_t, luminaire_rgb, uint32_t, uint32_t) = luminaire_pixel_dithered;
