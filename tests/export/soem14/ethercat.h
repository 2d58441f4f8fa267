/* Types and functions of SOEM 1.4 that generated headers use, written for tests. */
#ifndef ETHERCAT_H
#define ETHERCAT_H

#include <stdint.h>

typedef uint8_t boolean;
typedef uint8_t uint8;
typedef uint16_t uint16;
typedef uint32_t uint32;
typedef int32_t int32;

#define TRUE 1
#define FALSE 0
#define EC_TIMEOUTRET 2000
#define EC_TIMEOUTRXM 700000
#define EC_SOE_VALUE_B 0x40
#define EC_MAXSLAVE 200

typedef struct {
   uint16 configadr;
   uint32 eep_man;
   uint32 eep_id;
   uint32 eep_rev;
   uint16 Obits;
   uint32 Obytes;
   uint8 *outputs;
   uint8 Ostartbit;
   uint16 Ibits;
   uint32 Ibytes;
   uint8 *inputs;
   uint8 Istartbit;
   int (*PO2SOconfig)(uint16 slave);
} ec_slavet;

extern ec_slavet ec_slave[EC_MAXSLAVE];

int ec_SDOwrite(uint16 Slave, uint16 Index, uint8 SubIndex, boolean CA, int psize, void *p, int Timeout);
int ec_SoEwrite(uint16 slave, uint8 driveNo, uint8 elementflags, uint16 idn, int psize, void *p, int timeout);
int ec_FPWR(uint16 ADP, uint16 ADO, uint16 length, void *data, int timeout);
void ec_dcsync0(uint16 slave, boolean act, uint32 CyclTime, int32 CyclShift);
void ec_dcsync01(uint16 slave, boolean act, uint32 CyclTime0, uint32 CyclTime1, int32 CyclShift);

#endif
