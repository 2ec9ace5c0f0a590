#include "apps/techniques/shadow/words.h"

const char shadow_truth_words[] = "A ray through the centre of each pixel finds the surface that "
                                  "is seen, and a ray from there to the light whether a triangle "
                                  "is in its way, in double precision and without any map. Of a "
                                  "light that has a size, 16 points are asked for, and the share "
                                  "that is seen is the pixel's visibility.";

const TechniqueWord shadow_words[] = {
    { "wrong pixels",
      "Pixels that came out dark and are lit in truth, and the other way round: acne and leak "
      "together. Dark is what sees less than half of the light." },
    { "acne", "Wrong pixels that are dark although the light reaches them, mostly as specks and "
              "stripes on a surface that takes itself for something before it." },
    { "leak",
      "Wrong pixels that are lit although something is in the light's way, mostly along the "
      "edges of shadows and where things touch the ground." },
    { "rmse",
      "How far the visibility, the share of the light that a pixel sees, 0 to 1, is from the "
      "true one: the root of the mean square over all covered pixels." },
    { "covered", "Pixels in which a surface is seen, both in the picture and in truth: those that "
                 "are compared." },

    { "shadow map", "A picture of the scene as the light sees it, of depths instead of colours; "
                    "what is farther from the light than the map has it lies in shadow." },
    { "texel", "A cell of the map, as a pixel is one of the picture." },
    { "depth", "How far a surface is from the light, from 0 to 1 between the nearest and the "
               "farthest that the map holds." },
    { "bias",
      "What is taken from a pixel's depth before it is compared, so that a surface does not "
      "shadow itself: too little is acne, too much is leak." },

    { "plain, nearest", "The map's depths are kept as colours, and a pixel is compared with the "
                        "texel that is nearest "
                        "to it, with a fixed bias: the simplest of the printed methods." },
    { "plain, four compares",
      "As plain, nearest, with the four texels around the pixel, each compared, and "
      "their answers mixed by how near they are." },
    { "hardware, nearest",
      "The map is a depth surface that compares by itself when it is read; one "
      "texel, a fixed bias." },
    { "hardware, 2x2", "A depth surface that compares its four texels and mixes their answers; a "
                       "fixed bias." },
    { "slope-scaled bias",
      "As hardware, 2x2, without a fixed bias: the map's depths are moved away from the "
      "light, the more the steeper a surface lies to it." },
    { "dark by triangles",
      "As slope-scaled bias, and a triangle that faces away from the light is dark "
      "whatever the map and its smoothed normals say." },
    { "16 bits", "As dark by triangles, with 16 bits for a depth in the map." },
    { "far sides", "As dark by triangles, but only sides that face away from the light are drawn "
                   "into the map, so that errors of depth lie inside of things." },
    { "normal offset", "As dark by triangles, but a pixel is looked up half a texel above its "
                       "surface." },
    { "fit to casters", "As dark by triangles, but the map covers only the box of what can cast a "
                        "shadow instead of all that the light shines at, so that its texels are "
                        "smaller." },
    { "fit, near sides",
      "As fit to casters, with only the sides that face the light in the map, and "
      "depths of 32 bits." },
    { "fit to the eye", "As fit, near sides, but the map covers only what of that is seen, and is "
                        "warped, so that its texels are smaller near to the eye." },
    { "adaptive", "As fit, near sides, but where shadows end in the picture, tiles of the map are "
                  "drawn again, finer." },
    { "soft", "A map of plain depths; how far away the caster is tells how wide the half shadow of "
              "a light with a size is, and over so many texels answers are mixed." },
    { .word = NULL },
};
