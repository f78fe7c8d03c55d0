// Stands for the tests while their precompiled headers are made.
int main() {}
