/* How a light's map is shared out: what of the light's view the texels go to. */
#ifndef APPS_TECHNIQUES_SHADOW_LIGHT_FIT_H
#define APPS_TECHNIQUES_SHADOW_LIGHT_FIT_H

#include "apps/techniques/shadow/light_view.h"

/* Spreads a square around the casters over the map, with a margin for filters. A view in which there
 * are none stays. */
void light_fit_casters(const Scene *scene, const SceneLight *light, LightView *view);

/* Gives what is near to the eye more of a map that has been fitted to the casters, and nothing to
 * what the eye cannot see: a projective map of the map's plane, whose lines of equal density lie
 * across the way the eye looks.
 *
 * x y w are multiplied by a 3x3 matrix and z by a number, so that planes stay planes (slope-scaled
 * bias works as ever), order along each ray of the light is kept, and 0 <= z <= w where it held
 * before, on the map. All that lies along a ray of the light has one place on the map: what is seen
 * decides, and whatever shades it is there with it.
 *
 * It stands for perspective shadow maps (Stamminger and Drettakis, SIGGRAPH 2002), which warp by the
 * eye's own matrix. That turns inside out what is behind the eye, so that the eye must be moved back
 * until it sees all casters, and the map's quality jumps as it does; lights become points or sinks
 * of light by the side they are on. A perspective of the light's own space, square to its rays, has
 * neither, and its strength can be chosen.
 *
 * The view stays as it is where the eye looks along the light's rays (duelling frusta: what is near
 * and what is far then share a place on the map, and no warp of it can tell them apart), and where
 * nothing of the map is seen.
 * source Wimmer, Scherzer and Purgathofer, "Light space perspective shadow maps", EGSR 2004: n_opt
 *        of section 4. Theirs is for parallel rays; ours works after the light's own perspective,
 *        where all rays are parallel, at the scale of the middle of what is seen */
void light_fit_eye(const Scene *scene, const SceneLight *light, LightView *view);

#endif
