#include "apps/golden/limits.h"

#include "apps/compare/comparison.h"

static const double any = 1e300; /* no limit but this */

const SettingField comparison_fields[] = {
    { "fail", "F", "Call a pixel failing if it differs by more than F (default: 0)", SETTING_NUMBER,
      .offset = offsetof(ComparisonSettings, limits.fail), .high = any },
    { "failpercent", "P", "Allow P percent of failing pixels (default: 0)", SETTING_NUMBER,
      .offset = offsetof(ComparisonSettings, limits.fail_percent), .high = any },
    { "hardfail", "H", "Fail if any pixel differs by more than H", SETTING_NUMBER,
      .offset = offsetof(ComparisonSettings, limits.hard_fail), .high = any },
    { "warn", "F", "Warn about pixels that differ by more than F", SETTING_NUMBER,
      .offset = offsetof(ComparisonSettings, limits.warn), .high = any },
    { "warnpercent", "P", "Allow P percent of them (default: 0)", SETTING_NUMBER,
      .offset = offsetof(ComparisonSettings, limits.warn_percent), .high = any },
    { "hardwarn", "H", "Warn if any pixel differs by more than H", SETTING_NUMBER,
      .offset = offsetof(ComparisonSettings, limits.hard_warn), .high = any },
    { "flipfail", "F",
      "Fail if the mean FLIP is over F; without another limit this one alone judges",
      SETTING_NUMBER, .offset = offsetof(ComparisonSettings, flip_fail), .high = 1 },
    { "ppd", "N", "Pixels per degree of FLIP's viewer (default: 67.02, a 4K screen at 0.7 m)",
      SETTING_NUMBER, .offset = offsetof(ComparisonSettings, pixels_per_degree), 1,
      FLIP_MOST_PIXELS_PER_DEGREE },
    { "no-alpha", NULL, "Leave alpha out", SETTING_FLAG,
      .offset = offsetof(ComparisonSettings, no_alpha) },
    { .name = NULL },
};
