#include "ndframe/driver/main.hpp"

int main(int argc, char** argv)
{
  return ndframe::runMain(argc, argv);
}
