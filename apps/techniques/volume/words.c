#include "apps/techniques/volume/words.h"

const char volume_truth_words[] =
    "Values interpolated between the eight samples around each place, then classified, and light "
    "that is sent out and taken summed along the ray through each pixel's centre, in double "
    "precision, at eight places a sample or more.";

const TechniqueWord volume_words[] = {
    { "codes",
      "How far red, green and blue are from the truth over the whole picture on black, as the root "
      "of the mean square, of 255." },
    { "decibels", "The same error as peak signal to noise ratio: 20 log10 of 255 over codes." },
    { "bytes", "Memory that a sample takes as it is kept to be drawn; of splats one that is." },
    { "rays",
      "A ray for each pixel: at even steps values are interpolated and then classified; what shows "
      "nothing is stepped over." },
    { "planes",
      "Planes across the axis nearest to the view, in which values are interpolated between two "
      "slices and then classified, one over the other." },
    { "splat", "A sample, drawn as a spot that is densest in its middle." },
    { "splats", "Samples are classified and splatted, each as wide as its kernel is on the picture "
                "and wider by "
                "the pixel's filter; those of a sheet add up, and sheets hide those behind them." },
    { "splats, wider", "The same with kernels that blur more, and ripple less." },
    { "slabs", "Splats cut into slabs of equal depth instead of slices: nothing jumps as the "
               "volume turns." },
    { "classified after",
      "Splats of values, added up in slices and then classified: borders stay sharp." },
    { "flat", "Splats of which those that are opaque by half lie flat in their surface." },
    { "sums of floats", "Splats with sums of 32 bits instead of 16." },
    { "reconstruction alone",
      "Splats as wide as their kernels: those smaller than a pixel fall between pixels." },
    { "low-pass alone", "Splats of one width, the pixel's filter's: what is larger has holes." },
    { "as printed", "Splats of one slice a sheet, whose opacities add up, not what they take." },
    { .word = NULL },
};
