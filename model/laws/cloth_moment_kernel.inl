// The law of one piece of cloth, in all lanes; see cloth_law.cpp.
#include "laws/cloth_kernel.inl"

void follow(ClothMoment& moment) { moment.now = tensionOf(moment.law, moment.strain); }
