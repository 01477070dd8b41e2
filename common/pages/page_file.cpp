#include "common/pages/page_file.h"
