/*
 * Types and functions of the IgH EtherLab application interface that generated headers use, written for tests.
 * ECRT_MINOR 5 and 6 differ as the releases do: const pointers, results, feature macros.
 */
#ifndef ECRT_H
#define ECRT_H

#include <stddef.h>
#include <stdint.h>

#ifndef ECRT_MINOR
#define ECRT_MINOR 6
#endif

#define EC_HAVE_REG_BY_POS
#if ECRT_MINOR >= 6
#define EC_HAVE_STATE_TIMEOUT
#define ECRT_CONST const
#define ECRT_RESULT int
#else
#define ECRT_CONST
#define ECRT_RESULT void
#endif

#define EC_END ~0U
#define EC_MAX_SYNC_MANAGERS 16

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ec_master ec_master_t;
typedef struct ec_slave_config ec_slave_config_t;
typedef struct ec_domain ec_domain_t;

typedef enum { EC_DIR_INVALID, EC_DIR_OUTPUT, EC_DIR_INPUT, EC_DIR_COUNT } ec_direction_t;
typedef enum { EC_WD_DEFAULT, EC_WD_ENABLE, EC_WD_DISABLE } ec_watchdog_mode_t;
typedef enum {
    EC_AL_STATE_INIT = 1,
    EC_AL_STATE_PREOP = 2,
    EC_AL_STATE_SAFEOP = 4,
    EC_AL_STATE_OP = 8
} ec_al_state_t;

typedef struct {
    uint16_t index;
    uint8_t subindex;
    uint8_t bit_length;
} ec_pdo_entry_info_t;

typedef struct {
    uint16_t index;
    unsigned int n_entries;
    ec_pdo_entry_info_t ECRT_CONST *entries;
} ec_pdo_info_t;

typedef struct {
    uint8_t index;
    ec_direction_t dir;
    unsigned int n_pdos;
    ec_pdo_info_t ECRT_CONST *pdos;
    ec_watchdog_mode_t watchdog_mode;
} ec_sync_info_t;

typedef struct {
    uint16_t alias;
    uint16_t position;
    uint32_t vendor_id;
    uint32_t product_code;
    uint16_t index;
    uint8_t subindex;
    unsigned int *offset;
    unsigned int *bit_position;
} ec_pdo_entry_reg_t;

ec_slave_config_t *ecrt_master_slave_config(
        ec_master_t *master, uint16_t alias, uint16_t position, uint32_t vendor_id, uint32_t product_code);
int ecrt_master_sdo_download(
        ec_master_t *master, uint16_t slave_position, uint16_t index, uint8_t subindex,
        ECRT_CONST uint8_t *data, size_t data_size, uint32_t *abort_code);
int ecrt_master_sdo_download_complete(
        ec_master_t *master, uint16_t slave_position, uint16_t index,
        ECRT_CONST uint8_t *data, size_t data_size, uint32_t *abort_code);
int ecrt_master_write_idn(
        ec_master_t *master, uint16_t slave_position, uint8_t drive_no, uint16_t idn,
        ECRT_CONST uint8_t *data, size_t data_size, uint16_t *error_code);

int ecrt_slave_config_pdos(ec_slave_config_t *sc, unsigned int n_syncs, const ec_sync_info_t syncs[]);
int ecrt_slave_config_reg_pdo_entry_pos(
        ec_slave_config_t *sc, uint8_t sync_index, unsigned int pdo_pos, unsigned int entry_pos,
        ec_domain_t *domain, unsigned int *bit_position);
ECRT_RESULT ecrt_slave_config_watchdog(
        ec_slave_config_t *sc, uint16_t watchdog_divider, uint16_t watchdog_intervals);
ECRT_RESULT ecrt_slave_config_dc(
        ec_slave_config_t *sc, uint16_t assign_activate,
        uint32_t sync0_cycle, int32_t sync0_shift, uint32_t sync1_cycle, int32_t sync1_shift);
int ecrt_slave_config_sdo(
        ec_slave_config_t *sc, uint16_t index, uint8_t subindex, const uint8_t *data, size_t size);
int ecrt_slave_config_complete_sdo(ec_slave_config_t *sc, uint16_t index, const uint8_t *data, size_t size);
int ecrt_slave_config_idn(
        ec_slave_config_t *sc, uint8_t drive_no, uint16_t idn, ec_al_state_t state,
        const uint8_t *data, size_t size);
#ifdef EC_HAVE_STATE_TIMEOUT
int ecrt_slave_config_state_timeout(
        ec_slave_config_t *sc, ec_al_state_t from_state, ec_al_state_t to_state, unsigned int timeout_ms);
#endif
int ecrt_domain_reg_pdo_entry_list(ec_domain_t *domain, const ec_pdo_entry_reg_t *pdo_entry_regs);

#ifdef __cplusplus
}
#endif

#define EC_READ_BIT(DATA, POS) ((*((uint8_t *) (DATA)) >> (POS)) & 0x01)
#define EC_WRITE_BIT(DATA, POS, VAL) \
    do { \
        if (VAL) *((uint8_t *) (DATA)) |= (1 << (POS)); \
        else *((uint8_t *) (DATA)) &= ~(1 << (POS)); \
    } while (0)

/* For little-endian machines, as the real macros become there. */
#define EC_READ_U8(DATA) ((uint8_t) *((uint8_t *) (DATA)))
#define EC_READ_S8(DATA) ((int8_t) *((uint8_t *) (DATA)))
#define EC_READ_U16(DATA) ((uint16_t) *((uint16_t *) (DATA)))
#define EC_READ_S16(DATA) ((int16_t) *((uint16_t *) (DATA)))
#define EC_READ_U32(DATA) ((uint32_t) *((uint32_t *) (DATA)))
#define EC_READ_S32(DATA) ((int32_t) *((uint32_t *) (DATA)))
#define EC_READ_U64(DATA) ((uint64_t) *((uint64_t *) (DATA)))
#define EC_READ_S64(DATA) ((int64_t) *((uint64_t *) (DATA)))
#define EC_WRITE_U8(DATA, VAL) do { *((uint8_t *) (DATA)) = ((uint8_t) (VAL)); } while (0)
#define EC_WRITE_S8(DATA, VAL) EC_WRITE_U8(DATA, VAL)
#define EC_WRITE_U16(DATA, VAL) do { *((uint16_t *) (DATA)) = (uint16_t) (VAL); } while (0)
#define EC_WRITE_S16(DATA, VAL) EC_WRITE_U16(DATA, VAL)
#define EC_WRITE_U32(DATA, VAL) do { *((uint32_t *) (DATA)) = (uint32_t) (VAL); } while (0)
#define EC_WRITE_S32(DATA, VAL) EC_WRITE_U32(DATA, VAL)
#define EC_WRITE_U64(DATA, VAL) do { *((uint64_t *) (DATA)) = (uint64_t) (VAL); } while (0)
#define EC_WRITE_S64(DATA, VAL) EC_WRITE_U64(DATA, VAL)

#endif
