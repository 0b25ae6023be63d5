// Nothing but what cmake/MlabModule.cmake has read before it for all tests.
int main() { return 0; }
