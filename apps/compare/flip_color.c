#include "apps/compare/flip_color.h"

#include "apps/base/stable_math.h"

#include <math.h>

/* --- spaces ----------------------------------------------------------------------------------- */

/* Linear RGB to X/Xn, Y/Yn, Z/Zn: rows sum to 1. Exact, from the chromaticities (0.64, 0.33),
 * (0.30, 0.60), (0.15, 0.06) and the white. */
static const double xyz_of_rgb[3][3] = {
    { 10135552.0 / 23359437, 8788810.0 / 23359437, 4435075.0 / 23359437 },
    { 2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897 },
    { 1425312.0 / 80288307, 8788810.0 / 80288307, 70074185.0 / 80288307 },
};

/* Its inverse. */
static const double rgb_of_xyz[3][3] = {
    { 3.080341988280461, -1.5373989694887855, -0.5429430187916751 },
    { -0.9211783961651236, 1.875929983695176, 0.04524841246994758 },
    { 0.05288129287554325, -0.20401120612390997, 1.1511299132483668 },
};

static StablePair both(double value)
{
    return (StablePair){ value, value };
}

static void transform(const double matrix[3][3], const StablePair in[3], StablePair out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = matrix[i][0] * in[0] + matrix[i][1] * in[1] + matrix[i][2] * in[2];
}

/* IEC 61966-2-1 */
static void linear_of_srgb(const StablePair srgb[3], StablePair rgb[3])
{
    StablePair base[3], power[3];
    for (int i = 0; i < 3; i++)
        base[i] = (srgb[i] + 0.055) / 1.055;
    stable_pow_pairs(base, 2.4, power);
    for (int i = 0; i < 3; i++)
        rgb[i] = stable_choose(srgb[i] > 0.04045, power[i], srgb[i] / 12.92);
}

void flip_opponent(const StablePair srgb[3], StablePair opponent[3])
{
    StablePair rgb[3], xyz[3];
    linear_of_srgb(srgb, rgb);
    transform(xyz_of_rgb, rgb, xyz);
    opponent[0] = 116 * xyz[1] - 16;
    opponent[1] = 500 * (xyz[0] - xyz[1]);
    opponent[2] = 200 * (xyz[1] - xyz[2]);
}

/* CIE L*a*b*'s function: a cube root, with a straight line near 0. */
static void lab_of(const StablePair xyz[3], StablePair f[3])
{
    const double delta = 6.0 / 29;
    StablePair root[3];
    stable_pow_pairs(xyz, 1.0 / 3, root);
    for (int i = 0; i < 3; i++)
        f[i] = stable_choose(xyz[i] > delta * delta * delta, root[i],
                             xyz[i] / (3 * delta * delta) + 4.0 / 29);
}

/* L*, and a* and b* with Hunt's effect: colours look the paler the darker they are. */
static void hunt_lab_of_rgb(const StablePair rgb[3], StablePair lab[3])
{
    StablePair xyz[3], f[3];
    transform(xyz_of_rgb, rgb, xyz);
    lab_of(xyz, f);
    lab[0] = 116 * f[1] - 16;
    lab[1] = 0.01 * lab[0] * (500 * (f[0] - f[1]));
    lab[2] = 0.01 * lab[0] * (200 * (f[1] - f[2]));
}

static void hunt_lab_of_opponent(const StablePair opponent[3], StablePair lab[3])
{
    const StablePair y = (opponent[0] + 16) / 116;
    const StablePair xyz[3] = { y + opponent[1] / 500, y, y - opponent[2] / 200 };
    StablePair rgb[3];
    transform(rgb_of_xyz, xyz, rgb);
    for (int i = 0; i < 3; i++)
        rgb[i] = stable_choose(rgb[i] > 0, stable_choose(rgb[i] < 1, rgb[i], both(1)), both(0));
    hunt_lab_of_rgb(rgb, lab);
}

/* --- difference ------------------------------------------------------------------------------- */

/* Lightness by the city block, chroma by Euclid: Abasi, Tehran and Fairchild, "Distance metrics for
 * very large color differences", Color Research and Application 45(2), 2020; to the power of
 * 0.7. */
static StablePair distance(const StablePair a[3], const StablePair b[3])
{
    const StablePair dl = a[0] - b[0], da = a[1] - b[1], db = a[2] - b[2];
    const StablePair chroma = da * da + db * db;
    const StablePair apart = { fabs(dl[0]) + sqrt(chroma[0]), fabs(dl[1]) + sqrt(chroma[1]) };
    return stable_pow_pair(apart, both(0.7));
}

/* The largest that sRGB can show, green against blue, to the power of 0.7. The test finds it so. */
static const double largest = 41.276098414595445;

StablePair flip_color_difference(const StablePair a[3], const StablePair b[3])
{
    const double knee = 0.4 * largest, share = 0.95;
    StablePair lab_a[3], lab_b[3];
    hunt_lab_of_opponent(a, lab_a);
    hunt_lab_of_opponent(b, lab_b);
    const StablePair d = distance(lab_a, lab_b);
    return stable_choose(d < knee, d / knee * share,
                         share + (d - knee) / (largest - knee) * (1 - share));
}
