#ifndef LUMINAIRE_H
#define LUMINAIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Lights, points and pixels of luminaire, in integers. Written by cbindgen: do not edit.
 *
 * A coordinate has steps of 2^-16, a normal, a part and a colour steps of 2^-14, a direction steps
 * of 2^-30, and light steps of 2^-14 of full scale, which it may exceed.
 *
 * Pointers are aligned as their types are. A null pointer is an empty array, a dark light or
 * nothing to change. What a function writes does not overlap what it reads, but luminaire_spot_zoom
 * takes one light twice. A bool is true with any byte but 0. */

// Linear light, in steps of 2^-14 of full scale, which it may exceed.
typedef struct {
  // The red channel.
  uint32_t red;
  // The green channel.
  uint32_t green;
  // The blue channel.
  uint32_t blue;
} luminaire_light;

// A spotlight with the inverse square of the distance.
//
// With all words zero it is dark. What the words mean may change in any version.
typedef struct {
  // The words.
  uint32_t words[23];
} luminaire_spot;

// A point, in steps of 2^-16.
typedef struct {
  // First component.
  int32_t x;
  // Second component.
  int32_t y;
  // Third component.
  int32_t z;
} luminaire_point;

// A normal of unit length, in steps of 2^-14.
typedef struct {
  // First component.
  int16_t x;
  // Second component.
  int16_t y;
  // Third component.
  int16_t z;
} luminaire_normal;

// A vertex: a point and a normal of unit length.
typedef struct {
  // The point.
  luminaire_point point;
  // The normal.
  luminaire_normal normal;
} luminaire_vertex;

// A row of pixels on a flat surface: the first point, the step from pixel to pixel and the normal.
typedef struct {
  // The point of the first pixel.
  luminaire_point first;
  // What the point changes by from pixel to pixel.
  luminaire_point step;
  // The normal of the surface.
  luminaire_normal normal;
} luminaire_row;

// A spotlight in metres, degrees and linear colour.
typedef struct {
  // The position.
  float position[3];
  // The direction in which the light points, of any length.
  float axis[3];
  // The full beam angle, at which 50 % of the intensity is left, in degrees. 0 if the data sheet
  // does not name it: it then follows from the field angle and `is_hard`.
  float beam_degrees;
  // The full field angle, at which 10 % of the intensity is left, in degrees. 0 if the data sheet
  // does not name it: it then follows from the beam angle and `is_hard`.
  float field_degrees;
  // The intensity on the axis: 1 lights a surface at distance 1 to full scale.
  float intensity;
  // The linear colour, from 0 to 1.
  float color[3];
  // Whether the edge is hard, as of a profile, instead of soft, as of a Fresnel. Not read if both
  // angles are given, which determine the edge. With one angle, the beam angle is about 0.86 of
  // the field angle with a hard edge and 0.65 with a soft one.
  bool is_hard;
} luminaire_spot_description;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Returns the sum of two lights. It saturates.
luminaire_light luminaire_add(luminaire_light a, luminaire_light b);

// Returns light reflected by a surface of a linear colour, in steps of 2^-14 from 0 to 2^14.
luminaire_light luminaire_reflect(luminaire_light light, int16_t red, int16_t green, int16_t blue);

// Returns a pixel of RGB565, clipped at full scale.
uint16_t luminaire_rgb565(luminaire_light light);

// Returns a pixel of RGB565 at `(x, y)` with ordered dither, clipped at full scale.
uint16_t luminaire_rgb565_dithered(luminaire_light light, uint32_t x, uint32_t y);

// Returns a pixel of three sRGB codes, `0xRRGGBB`, clipped at full scale.
uint32_t luminaire_srgb(luminaire_light light);

// Writes the light of all spotlights at each vertex.
//
// # Safety
// `spots` points to `spot_count` lights, and `vertices` and `lights` to `count` elements each.
void luminaire_vertices(const luminaire_spot *spots,
                        size_t spot_count,
                        const luminaire_vertex *vertices,
                        luminaire_light *lights,
                        size_t count);

// Adds the light of a spotlight to each pixel of a row that it reaches.
//
// # Safety
// `lights` points to `count` elements.
void luminaire_row_add(const luminaire_row *row,
                       const luminaire_spot *spot,
                       luminaire_light *lights,
                       size_t count);

// Writes the pixels of RGB565 of a row that has light; the other pixels keep their values. `row` is
// the number of the row in the picture, for the dither; `is_big_endian` swaps the bytes.
//
// # Safety
// `lights` and `pixels` point to `count` elements each.
void luminaire_row_rgb565(const luminaire_light *lights,
                          uint16_t *pixels,
                          size_t count,
                          uint32_t row,
                          bool is_big_endian);

// Sets up a light, on a processor with or without a floating-point unit. Returns whether the
// description is accepted. If not, the light is dark, and `message` gets the reason, cut to
// `capacity` bytes with the final zero; it may be null.
//
// Firmware that need not set lights up by itself includes a light that `luminaire export` writes.
//
// # Safety
// `message` is null or points to `capacity` bytes.
bool luminaire_spot_set_up(luminaire_spot *spot,
                           const luminaire_spot_description *description,
                           char *message,
                           size_t capacity);

// Returns the irradiance at a surface point, before the light's colour.
uint32_t luminaire_spot_irradiance(const luminaire_spot *spot,
                                   luminaire_point point,
                                   luminaire_normal normal);

// Returns the light at a surface point: the irradiance times the light's colour.
//
// Each call checks the words of the light. `luminaire_vertices` and `luminaire_row_add` check them once
// for many points.
luminaire_light luminaire_spot_light(const luminaire_spot *spot,
                                     luminaire_point point,
                                     luminaire_normal normal);

// Returns the falloff of the cone at a point, from 0 to 2^14.
int16_t luminaire_spot_falloff(const luminaire_spot *spot, luminaire_point point);

// Returns whether the light may reach points within `radius` of `center`; the radius has steps of
// 2^-16.
bool luminaire_spot_can_reach(const luminaire_spot *spot, luminaire_point center, int32_t radius);

// Moves the light; its axis stays.
void luminaire_spot_move(luminaire_spot *spot, luminaire_point position);

// Aims the light at a point. Returns false, and leaves the light as it is, if the point is the
// light's position.
bool luminaire_spot_aim(luminaire_spot *spot, luminaire_point point);

// Aims the light along a vector of any length. Returns false, and leaves the light as it is, if the
// vector is zero.
bool luminaire_spot_aim_along(luminaire_spot *spot, int32_t x, int32_t y, int32_t z);

// Dims the light to a part of its intensity, in steps of 2^-14 from 0 to 2^14.
void luminaire_spot_dim(luminaire_spot *spot, int16_t part);

// Gives the light a linear colour, in steps of 2^-14 from 0 to 2^14.
void luminaire_spot_tint(luminaire_spot *spot, int16_t red, int16_t green, int16_t blue);

// Gives the light a cone between its own (`part` 0) and that of another light (`part` 2^14). The
// edge of the light keeps its shape.
//
// # Safety
// Each pointer is null or points to a light, which may be the same.
void luminaire_spot_zoom(luminaire_spot *spot, const luminaire_spot *other, int16_t part);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* LUMINAIRE_H */
