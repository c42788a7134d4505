#include "truth/closed_form.h"
