/* A SOEM 1.4 that prints what it is told. */
#include <stdio.h>

#include "ethercat.h"

ec_slavet ec_slave[EC_MAXSLAVE];

/* Index of an object that the slave does not let be written. */
#ifndef REFUSED
#define REFUSED 0
#endif

static int print_data(const void *p, int size)
{
   for (int i = 0; i < size; i++)
      printf("%02x", ((const uint8 *) p)[i]);
   printf("\n");
   return 1;
}

int ec_SDOwrite(uint16 Slave, uint16 Index, uint8 SubIndex, boolean CA, int psize, void *p, int Timeout)
{
   (void) Timeout;
   printf("sdo %u 0x%04x:%02x%s ", Slave, Index, SubIndex, CA ? " complete" : "");
   return print_data(p, psize) && Index != REFUSED;
}

int ec_SoEwrite(uint16 slave, uint8 driveNo, uint8 elementflags, uint16 idn, int psize, void *p, int timeout)
{
   (void) timeout;
   printf("idn %u %u 0x%02x 0x%04x ", slave, driveNo, elementflags, idn);
   return print_data(p, psize);
}

int ec_FPWR(uint16 ADP, uint16 ADO, uint16 length, void *data, int timeout)
{
   (void) timeout;
   printf("register 0x%04x 0x%04x ", ADP, ADO);
   return print_data(data, length);
}

void ec_dcsync0(uint16 slave, boolean act, uint32 CyclTime, int32 CyclShift)
{
   printf("dcsync0 %u %u %u %d\n", slave, act, CyclTime, CyclShift);
}

void ec_dcsync01(uint16 slave, boolean act, uint32 CyclTime0, uint32 CyclTime1, int32 CyclShift)
{
   printf("dcsync01 %u %u %u %u %d\n", slave, act, CyclTime0, CyclTime1, CyclShift);
}
