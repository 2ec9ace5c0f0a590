/* Blinn-Phong lighting per vertex, one directional light. */
#ifndef SHADERS_GOURAUD_H
#define SHADERS_GOURAUD_H

#include "shaders_c/materials/phong.h" /* PhongUniforms */

extern const GpProgram gouraud_program;

#endif
