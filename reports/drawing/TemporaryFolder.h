#pragma once

#include "framework/support/TemporaryFolder.h"
