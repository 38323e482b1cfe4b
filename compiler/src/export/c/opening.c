/* The mechanism `@name`, written out by Linkwright @version; @m.h says what can be called. */

#include "@m.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#if defined(__FAST_MATH__) && (__FAST_MATH__ != 0)
#error "-ffast-math takes infinities and NaNs for impossible, which steps look for; build without it"
#endif

