/* A texture with Blinn-Phong lighting per pixel, by the normals of another. */
#ifndef SHADERS_MAPPED_PHONG_H
#define SHADERS_MAPPED_PHONG_H

#include "shaders_c/materials/phong.h" /* PhongUniforms */

extern const GpProgram mapped_phong_program;

#endif
