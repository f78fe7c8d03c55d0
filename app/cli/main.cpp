#include "base/laws.h"
int main() {}
