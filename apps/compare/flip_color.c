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

static void transform(const double matrix[3][3], const double in[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = matrix[i][0] * in[0] + matrix[i][1] * in[1] + matrix[i][2] * in[2];
}

/* IEC 61966-2-1 */
static double linear_of_srgb(double code)
{
    return code > 0.04045 ? stable_pow((code + 0.055) / 1.055, 2.4) : code / 12.92;
}

void flip_opponent(const double srgb[3], double opponent[3])
{
    double rgb[3], xyz[3];
    for (int i = 0; i < 3; i++)
        rgb[i] = linear_of_srgb(srgb[i]);
    transform(xyz_of_rgb, rgb, xyz);
    opponent[0] = 116 * xyz[1] - 16;
    opponent[1] = 500 * (xyz[0] - xyz[1]);
    opponent[2] = 200 * (xyz[1] - xyz[2]);
}

/* CIE L*a*b*'s function: a cube root, with a straight line near 0. */
static double lab_of(double x)
{
    const double delta = 6.0 / 29;
    return x > delta * delta * delta ? stable_pow(x, 1.0 / 3) : x / (3 * delta * delta) + 4.0 / 29;
}

/* L*, and a* and b* with Hunt's effect: colours look the paler the darker they are. */
static void hunt_lab_of_rgb(const double rgb[3], double lab[3])
{
    double xyz[3];
    transform(xyz_of_rgb, rgb, xyz);
    const double x = lab_of(xyz[0]), y = lab_of(xyz[1]), z = lab_of(xyz[2]);
    lab[0] = 116 * y - 16;
    lab[1] = 0.01 * lab[0] * (500 * (x - y));
    lab[2] = 0.01 * lab[0] * (200 * (y - z));
}

static void hunt_lab_of_opponent(const double opponent[3], double lab[3])
{
    const double y = (opponent[0] + 16) / 116;
    const double xyz[3] = { y + opponent[1] / 500, y, y - opponent[2] / 200 };
    double rgb[3];
    transform(rgb_of_xyz, xyz, rgb);
    for (int i = 0; i < 3; i++)
        rgb[i] = rgb[i] > 0 ? rgb[i] < 1 ? rgb[i] : 1 : 0;
    hunt_lab_of_rgb(rgb, lab);
}

/* --- difference ------------------------------------------------------------------------------- */

/* Lightness by the city block, chroma by Euclid: Abasi, Tehran and Fairchild, "Distance metrics for
 * very large color differences", Color Research and Application 45(2), 2020; to the power of 0.7. */
static double distance(const double a[3], const double b[3])
{
    const double da = a[1] - b[1], db = a[2] - b[2];
    return stable_pow(fabs(a[0] - b[0]) + sqrt(da * da + db * db), 0.7);
}

/* The largest that sRGB can show, green against blue, to the power of 0.7. The test finds it so. */
static const double largest = 41.276098414595445;

double flip_color_difference(const double a[3], const double b[3])
{
    const double knee = 0.4 * largest, share = 0.95;
    double lab_a[3], lab_b[3];
    hunt_lab_of_opponent(a, lab_a);
    hunt_lab_of_opponent(b, lab_b);
    const double d = distance(lab_a, lab_b);
    return d < knee ? d / knee * share : share + (d - knee) / (largest - knee) * (1 - share);
}
