/*
 * A master that only computes: it places entries as IgH EtherLab does (bit by bit in a SyncManager, SyncManagers one
 * after the other in the domain, in the order of registration) and prints what it is told.
 */
#include <stdio.h>
#include <stdlib.h>

#include "ecrt.h"

struct ec_slave_config {
    const ec_sync_info_t *syncs;
    int domain_offset[EC_MAX_SYNC_MANAGERS];
};

static struct ec_slave_config the_config;
static unsigned int domain_size;

static void print_data(const uint8_t *data, size_t size)
{
    for (size_t i = 0; i < size; i++)
        printf("%02x", data[i]);
    printf("\n");
}

ec_slave_config_t *ecrt_master_slave_config(
        ec_master_t *master, uint16_t alias, uint16_t position, uint32_t vendor_id, uint32_t product_code)
{
    (void) master;
    printf("slave %u %u 0x%08x 0x%08x\n", alias, position, vendor_id, product_code);
    for (int i = 0; i < EC_MAX_SYNC_MANAGERS; i++)
        the_config.domain_offset[i] = -1;
    return &the_config;
}

int ecrt_slave_config_pdos(ec_slave_config_t *sc, unsigned int n_syncs, const ec_sync_info_t syncs[])
{
    for (unsigned int i = 0; i < n_syncs && syncs[i].index != 0xff; i++)
        printf("sm %u dir %d pdos %u watchdog %d\n", syncs[i].index, syncs[i].dir, syncs[i].n_pdos,
                syncs[i].watchdog_mode);
    sc->syncs = syncs;
    return 0;
}

static int place(ec_slave_config_t *sc, const ec_sync_info_t *sync, unsigned int bits, unsigned int *bit_position)
{
    unsigned int total = 0;

    if (bit_position)
        *bit_position = bits % 8;
    else if (bits % 8)
        return -14;
    for (unsigned int p = 0; p < sync->n_pdos; p++)
        for (unsigned int e = 0; e < sync->pdos[p].n_entries; e++)
            total += sync->pdos[p].entries[e].bit_length;
    if (sc->domain_offset[sync->index] < 0) {
        sc->domain_offset[sync->index] = (int) domain_size;
        domain_size += (total + 7) / 8;
    }
    return sc->domain_offset[sync->index] + (int) bits / 8;
}

static int find(ec_slave_config_t *sc, uint16_t index, uint8_t subindex, unsigned int *bit_position)
{
    for (const ec_sync_info_t *sync = sc->syncs; sync->index != 0xff; sync++) {
        unsigned int bits = 0;

        for (unsigned int p = 0; p < sync->n_pdos; p++)
            for (unsigned int e = 0; e < sync->pdos[p].n_entries; e++) {
                const ec_pdo_entry_info_t *entry = &sync->pdos[p].entries[e];

                if (entry->index == index && entry->subindex == subindex)
                    return place(sc, sync, bits, bit_position);
                bits += entry->bit_length;
            }
    }
    return -2;
}

int ecrt_slave_config_reg_pdo_entry_pos(
        ec_slave_config_t *sc, uint8_t sync_index, unsigned int pdo_pos, unsigned int entry_pos,
        ec_domain_t *domain, unsigned int *bit_position)
{
    (void) domain;
    for (const ec_sync_info_t *sync = sc->syncs; sync->index != 0xff; sync++) {
        unsigned int bits = 0;

        if (sync->index != sync_index)
            continue;
        for (unsigned int p = 0; p < sync->n_pdos; p++)
            for (unsigned int e = 0; e < sync->pdos[p].n_entries; e++) {
                if (p == pdo_pos && e == entry_pos)
                    return place(sc, sync, bits, bit_position);
                bits += sync->pdos[p].entries[e].bit_length;
            }
    }
    return -2;
}

int ecrt_domain_reg_pdo_entry_list(ec_domain_t *domain, const ec_pdo_entry_reg_t *regs)
{
    (void) domain;
    for (; regs->index; regs++) {
        const int offset = find(&the_config, regs->index, regs->subindex, regs->bit_position);

        if (offset < 0)
            return offset;
        *regs->offset = (unsigned int) offset;
        printf("entry 0x%04x:%02x byte %d bit %u\n", regs->index, regs->subindex, offset,
                regs->bit_position ? *regs->bit_position : 0);
    }
    return 0;
}

int ecrt_slave_config_watchdog(ec_slave_config_t *sc, uint16_t divider, uint16_t intervals)
{
    (void) sc;
    printf("watchdog %u %u\n", divider, intervals);
    return 0;
}

int ecrt_slave_config_dc(
        ec_slave_config_t *sc, uint16_t assign_activate,
        uint32_t sync0_cycle, int32_t sync0_shift, uint32_t sync1_cycle, int32_t sync1_shift)
{
    (void) sc;
    printf("dc 0x%04x %u %d %u %d\n", assign_activate, sync0_cycle, sync0_shift, sync1_cycle, sync1_shift);
    return 0;
}

int ecrt_slave_config_sdo(
        ec_slave_config_t *sc, uint16_t index, uint8_t subindex, const uint8_t *data, size_t size)
{
    (void) sc;
    printf("sdo 0x%04x:%02x ", index, subindex);
    print_data(data, size);
    return 0;
}

int ecrt_slave_config_complete_sdo(ec_slave_config_t *sc, uint16_t index, const uint8_t *data, size_t size)
{
    (void) sc;
    printf("complete sdo 0x%04x ", index);
    print_data(data, size);
    return 0;
}

int ecrt_slave_config_idn(
        ec_slave_config_t *sc, uint8_t drive_no, uint16_t idn, ec_al_state_t state,
        const uint8_t *data, size_t size)
{
    (void) sc;
    printf("idn %u 0x%04x state %d ", drive_no, idn, state);
    print_data(data, size);
    return 0;
}

int ecrt_slave_config_state_timeout(
        ec_slave_config_t *sc, ec_al_state_t from_state, ec_al_state_t to_state, unsigned int timeout_ms)
{
    (void) sc;
    printf("timeout %d %d %u\n", from_state, to_state, timeout_ms);
    return 0;
}

int ecrt_master_sdo_download(
        ec_master_t *master, uint16_t slave_position, uint16_t index, uint8_t subindex,
        const uint8_t *data, size_t data_size, uint32_t *abort_code)
{
    (void) master;
    (void) abort_code;
    printf("download %u 0x%04x:%02x ", slave_position, index, subindex);
    print_data(data, data_size);
    return 0;
}

int ecrt_master_sdo_download_complete(
        ec_master_t *master, uint16_t slave_position, uint16_t index,
        const uint8_t *data, size_t data_size, uint32_t *abort_code)
{
    (void) master;
    (void) abort_code;
    printf("complete download %u 0x%04x ", slave_position, index);
    print_data(data, data_size);
    return 0;
}

int ecrt_master_write_idn(
        ec_master_t *master, uint16_t slave_position, uint8_t drive_no, uint16_t idn,
        const uint8_t *data, size_t data_size, uint16_t *error_code)
{
    (void) master;
    (void) error_code;
    printf("write idn %u %u 0x%04x ", slave_position, drive_no, idn);
    print_data(data, data_size);
    return 0;
}
