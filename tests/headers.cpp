// What the headers of tests are precompiled for.
int main() {}
