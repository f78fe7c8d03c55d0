// The law of cloth at one moment, for what is not a kernel; see cloth_law.cpp.
#include "laws/cloth_kernel.inl"

void follow(const ClothLawPack& law, const Coordinates& strain, ClothTensionPack& now)
{
    now = tensionOf(law, strain);
}
