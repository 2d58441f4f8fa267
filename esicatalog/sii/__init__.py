"""SII images: the EEPROM of a slave controller, decoded to records and encoded from them (ETG.1000.6, ETG.2010)."""
