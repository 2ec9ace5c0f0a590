#ifndef GP_DETMATH_H
#define GP_DETMATH_H
#include "pipeline/lanes.h"
GP_INLINE flt math_floor(flt a){return a;}
GP_INLINE flt math_frc(flt a){return a;}
GP_INLINE flt math_rcp(flt a){return 1.0f/a;}
GP_INLINE flt math_rsq(flt a){return 1.0f/flt_sqrt(a);}
GP_INLINE flt math_exp2(flt a){return a;}
GP_INLINE flt math_log2_d3d(flt a){return a;}
GP_INLINE flt math_pow(flt a,flt b){return a*b;}
GP_INLINE flt math_sin(flt a){return a;}
GP_INLINE flt math_cos(flt a){return a;}
#endif
