/* A texture with Blinn-Phong lighting per pixel, one directional light. */
#ifndef SHADERS_TEXTURED_PHONG_H
#define SHADERS_TEXTURED_PHONG_H

#include "shaders_c/materials/phong.h" /* PhongUniforms */

extern const GpProgram textured_phong_program;

#endif
