BEGIN TRANSACTION;
CREATE TABLE alembic_version (
	version_num VARCHAR(32) NOT NULL,
	CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num)
);
INSERT INTO "alembic_version" VALUES('0014');
CREATE TABLE archives (
	id INTEGER NOT NULL,
	location TEXT NOT NULL,
	sha256 TEXT NOT NULL,
	reader_version TEXT NOT NULL,
	CONSTRAINT pk_archives PRIMARY KEY (id),
	CONSTRAINT uq_archives_location UNIQUE (location)
)
 STRICT;
CREATE TABLE catalog_state (
	"key" TEXT NOT NULL,
	value TEXT NOT NULL,
	CONSTRAINT pk_catalog_state PRIMARY KEY ("key")
)
 STRICT;
INSERT INTO "catalog_state" VALUES('turns','2');
INSERT INTO "catalog_state" VALUES('content_hash','f29e3acdc23b113c0bd61ef09b01f3b6b8c754b1192fb6fcd6be8bb319002f45');
INSERT INTO "catalog_state" VALUES('state_hash','0142d84a0477b47bd8c325e03ac570436860ff94a94dfe743d8f77d751c9c462');
CREATE TABLE data_types (
	id INTEGER NOT NULL,
	content_hash BLOB NOT NULL,
	type_index INTEGER,
	name TEXT,
	base_type TEXT,
	comments TEXT,
	bit_size INTEGER,
	array_infos TEXT,
	properties TEXT,
	xml TEXT,
	spelling TEXT,
	CONSTRAINT pk_data_types PRIMARY KEY (id),
	CONSTRAINT uq_data_types_content_hash UNIQUE (content_hash)
)
 STRICT;
INSERT INTO "data_types" VALUES(1,X'BB95F7E3CDAAF3E43DBB580E115E80CB',NULL,'SINT',NULL,NULL,8,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(2,X'2AAE5B5127E286A40FC182EB5DCD1970',NULL,'USINT',NULL,NULL,8,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(3,X'49E0351174BB21DFFD7792289B83CC07',NULL,'INT',NULL,NULL,16,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(4,X'C05E6F8C1C041C31C745A9A6346449ED',NULL,'UINT',NULL,NULL,16,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(5,X'BAF08A1EAA4CC3A5DD8046425D1A8A9C',NULL,'DINT',NULL,NULL,32,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(6,X'A7C4B6B5AE0BA50B5A7EE551E3500FA9',NULL,'UDINT',NULL,NULL,32,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(7,X'7D2BD6DD00117269F3DB2F2F2B9C0F9A',NULL,'DT1700',NULL,NULL,144,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(8,X'BBA39EFFF14F1818748BDD955C384085',NULL,'DT1B00',NULL,NULL,240,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(9,X'BE8DD4AC9F88E35129FC12D22303B55A',NULL,'DT608F',NULL,NULL,80,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(10,X'3B9B0559CB8E9F996916370248CEF619',NULL,'DT60C2',NULL,NULL,32,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(11,X'528572B8514DDBC80553C5D16EA8D979',NULL,'DT1701',NULL,NULL,112,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(12,X'05FB03B1788D50BD5945200C6D354709',NULL,'DT1B01',NULL,NULL,208,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(13,X'830A8D032D9757CE7BEB6C24BA5D55D6',NULL,'DT1702',NULL,NULL,80,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(14,X'9FD4EAC81B6408C116B6FDC682033A90',NULL,'DT1B02',NULL,NULL,208,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(15,X'99E0C82FC6B069F65898C722D4DA30E3',NULL,'DT1703',NULL,NULL,112,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(16,X'870A7CDDDD0ED14FB0D7C113BC1D67D4',NULL,'DT1B03',NULL,NULL,208,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(17,X'9A00C0DD728C488EB43DB7C2FEC402B2',NULL,'BOOL',NULL,NULL,1,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(18,X'5678183D5AB3EA608EE9B96A8317B945',NULL,'STRING(4)',NULL,NULL,32,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(19,X'5131FB0EC30E84C90B6D880B2BC9531E',NULL,'STRING(8)',NULL,NULL,64,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(20,X'C2EB225D3E96E0AC3D0D958B5DE81023',NULL,'DT1018',NULL,NULL,144,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(21,X'A72A3B041934F09508992C731FB05FF2',NULL,'DT1C00ARR','USINT',NULL,32,'[{"lbound":1,"elements":4}]',NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(22,X'61EE5D90D6588B0099AA5FC8B6DAF17B',NULL,'DT1C00',NULL,NULL,48,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(23,X'C652B7F6C613567A73C9C35CF132F70B',NULL,'DT1C12ARR','UINT',NULL,32,'[{"lbound":1,"elements":2}]',NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(24,X'42534AC4B0A24EBA6B1D4DE6447D6029',NULL,'DT1C12',NULL,NULL,48,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(25,X'3CBFB20EBA1AAC2E26DFB70072380AB7',NULL,'DT1C13ARR','UINT',NULL,32,'[{"lbound":1,"elements":2}]',NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(26,X'FE6A8CDA6FEC7F063AF13DFB4A440903',NULL,'DT1C13',NULL,NULL,48,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(27,X'CA5CA24C6E0F50813A7DAF997C76371B',NULL,'DT1C32',NULL,NULL,488,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(28,X'A02AD6107F7CAA2C888C82FAC02271E7',NULL,'DT10F1',NULL,NULL,64,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(29,X'127684CF6DBF657A5E5562EAD588C317',NULL,'DTF000',NULL,NULL,48,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(30,X'8647B78E7C7F0737637DFD2574D19F52',NULL,'DTF010ARR','UDINT',NULL,64,'[{"lbound":1,"elements":2}]',NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(31,X'324B14AF7F8B035FB2E47A5C2C734176',NULL,'DTF010',NULL,NULL,80,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(32,X'38448A61C2046B2D55C38AE7ECED96E5',NULL,'DTF030ARR','UDINT',NULL,64,'[{"lbound":1,"elements":2}]',NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(33,X'DAAD5B3EB5C49093795AF714938CD299',NULL,'DTF030',NULL,NULL,80,NULL,NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(34,X'80EA50362352B2E69379F166D3A33778',NULL,'DTF050ARR','UDINT',NULL,64,'[{"lbound":1,"elements":2}]',NULL,NULL,NULL);
INSERT INTO "data_types" VALUES(35,X'DB4DFE027AB31FE2E134C54F523D4672',NULL,'DTF050',NULL,NULL,80,NULL,NULL,NULL,NULL);
CREATE TABLE dc_modes (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	name TEXT,
	description TEXT,
	assign_activate INTEGER,
	cycle_time_sync0_ns INTEGER,
	cycle_time_sync0_factor INTEGER,
	shift_time_sync0_ns INTEGER,
	shift_time_sync0_factor INTEGER,
	shift_time_sync0_input INTEGER,
	shift_time_sync0_output_delay_ns INTEGER,
	shift_time_sync0_input_delay_ns INTEGER,
	cycle_time_sync1_ns INTEGER,
	cycle_time_sync1_factor INTEGER,
	shift_time_sync1_ns INTEGER,
	shift_time_sync1_factor INTEGER,
	shift_time_sync1_input INTEGER,
	shift_time_sync1_output_delay_ns INTEGER,
	shift_time_sync1_input_delay_ns INTEGER,
	activate_additional INTEGER,
	cycle_time_sync2_ns INTEGER,
	cycle_time_sync2_factor INTEGER,
	shift_time_sync2_ns INTEGER,
	cycle_time_sync3_ns INTEGER,
	cycle_time_sync3_factor INTEGER,
	shift_time_sync3_ns INTEGER,
	sm_assignments TEXT,
	spelling TEXT,
	dc_active INTEGER,
	sync0 INTEGER,
	sync1 INTEGER,
	time_only INTEGER,
	sync_unit_pdi INTEGER,
	latch0_pdi INTEGER,
	latch1_pdi INTEGER,
	CONSTRAINT pk_dc_modes PRIMARY KEY (id),
	CONSTRAINT ck_dc_modes_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_dc_modes_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_dc_modes_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "dc_modes" VALUES(1,1,NULL,0,'Synchron','SM-Synchron',0,0,0,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"assign_activate":"0"}',0,0,0,0,0,0,0);
INSERT INTO "dc_modes" VALUES(2,1,NULL,1,'DcSync0','DC: inputs latched and outputs set with SYNC0',768,0,1,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"assign_activate":"#x300"}',1,1,0,0,0,0,0);
INSERT INTO "dc_modes" VALUES(3,2,NULL,0,'Synchron','SM-Synchron',0,0,0,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"assign_activate":"0"}',0,0,0,0,0,0,0);
INSERT INTO "dc_modes" VALUES(4,2,NULL,1,'DcSync0','DC: inputs latched and outputs set with SYNC0',768,0,1,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"assign_activate":"#x300"}',1,1,0,0,0,0,0);
INSERT INTO "dc_modes" VALUES(5,2,NULL,2,'DcSync01','DC: inputs latched with SYNC0, outputs set with SYNC1',1792,0,1,0,NULL,NULL,NULL,NULL,0,1,20000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"assign_activate":"#x700"}',1,1,1,0,0,0,0);
INSERT INTO "dc_modes" VALUES(6,3,NULL,0,'DC','DC with SYNC0',768,0,1,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"assign_activate":"#x300"}',1,1,0,0,0,0,0);
INSERT INTO "dc_modes" VALUES(7,3,NULL,1,'SM','SM-Synchron',0,0,0,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"assign_activate":"#x0"}',0,0,0,0,0,0,0);
CREATE TABLE device_facts (
	device_id INTEGER NOT NULL,
	output_bytes INTEGER,
	input_bytes INTEGER,
	dc_supported INTEGER,
	dc_needed INTEGER,
	runs_without_dc INTEGER,
	supports_sync0 INTEGER,
	supports_sync1 INTEGER,
	uses_latch INTEGER,
	output_sync_types INTEGER,
	input_sync_types INTEGER,
	min_cycle_ns INTEGER,
	axis_count INTEGER,
	has_bootstrap INTEGER,
	image_signature TEXT,
	pdo_signature TEXT,
	fsoe TEXT,
	fsoe_evidence TEXT,
	CONSTRAINT pk_device_facts PRIMARY KEY (device_id),
	CONSTRAINT fk_device_facts_device_id FOREIGN KEY(device_id) REFERENCES devices (id)
)
 STRICT;
INSERT INTO "device_facts" VALUES(1,1,1,1,0,1,1,0,0,NULL,NULL,NULL,0,0,'3a3ccbe9901d9729aad33d6aef0b3466','864ecdd9ad63ad9cd25f98f0ec38b9f1',NULL,NULL);
INSERT INTO "device_facts" VALUES(2,1,1,1,0,1,1,1,0,NULL,NULL,NULL,0,0,'3a3ccbe9901d9729aad33d6aef0b3466','864ecdd9ad63ad9cd25f98f0ec38b9f1',NULL,NULL);
INSERT INTO "device_facts" VALUES(3,24,36,1,0,1,1,0,0,6,6,125000,2,1,'177ab7a5739ab82c9782000c99405960',NULL,NULL,NULL);
CREATE TABLE device_modules (
	device_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	module_id INTEGER NOT NULL,
	CONSTRAINT pk_device_modules PRIMARY KEY (device_id, position),
	CONSTRAINT fk_device_modules_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_device_modules_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 WITHOUT ROWID,
 STRICT;
INSERT INTO "device_modules" VALUES(3,0,1);
INSERT INTO "device_modules" VALUES(3,1,2);
INSERT INTO "device_modules" VALUES(3,2,3);
INSERT INTO "device_modules" VALUES(3,3,4);
CREATE TABLE device_names (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	kind TEXT NOT NULL,
	position INTEGER NOT NULL,
	lcid INTEGER,
	text TEXT NOT NULL,
	CONSTRAINT pk_device_names PRIMARY KEY (id),
	CONSTRAINT fk_device_names_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_device_names_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "device_names" VALUES(1,1,NULL,'name',0,1033,'ECX-D808 8 digital inputs, 8 digital outputs 24V, 0.5A');
INSERT INTO "device_names" VALUES(2,1,NULL,'name',1,1031,'ECX-D808 8 digitale Eingänge, 8 digitale Ausgänge 24V, 0,5A');
INSERT INTO "device_names" VALUES(3,2,NULL,'name',0,1033,'ECX-D808 8 digital inputs, 8 digital outputs 24V, 0.5A');
INSERT INTO "device_names" VALUES(4,2,NULL,'name',1,1031,'ECX-D808 8 digitale Eingänge, 8 digitale Ausgänge 24V, 0,5A');
INSERT INTO "device_names" VALUES(5,NULL,1,'name',0,1033,'Cyclic synchronous position mode (CSP)');
INSERT INTO "device_names" VALUES(6,NULL,2,'name',0,1033,'Cyclic synchronous velocity mode (CSV)');
INSERT INTO "device_names" VALUES(7,NULL,3,'name',0,1033,'Cyclic synchronous torque mode (CST)');
INSERT INTO "device_names" VALUES(8,NULL,4,'name',0,1033,'Cyclic synchronous torque mode with commutation angle (CSTCA)');
INSERT INTO "device_names" VALUES(9,3,NULL,'name',0,1033,'ECX-A202 two axis servo drive');
INSERT INTO "device_names" VALUES(10,3,NULL,'name',1,1031,'ECX-A202 Zweiachs-Servoverstärker');
CREATE TABLE device_sources (
	id INTEGER NOT NULL,
	device_id INTEGER NOT NULL,
	source_id INTEGER NOT NULL,
	section INTEGER NOT NULL,
	position INTEGER NOT NULL,
	line INTEGER NOT NULL,
	group_type TEXT,
	CONSTRAINT pk_device_sources PRIMARY KEY (id),
	CONSTRAINT fk_device_sources_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_device_sources_source_id FOREIGN KEY(source_id) REFERENCES sources (id)
)
 STRICT;
INSERT INTO "device_sources" VALUES(1,1,1,0,0,29,'EcxDigital');
INSERT INTO "device_sources" VALUES(2,2,1,0,1,295,'EcxDigital');
INSERT INTO "device_sources" VALUES(3,3,2,0,0,22,'EcxDrives');
CREATE TABLE devices (
	id INTEGER NOT NULL,
	vendor_id INTEGER,
	variant INTEGER NOT NULL,
	content_hash TEXT NOT NULL,
	type TEXT,
	product_code INTEGER,
	revision_no INTEGER,
	serial_no INTEGER,
	check_product_code TEXT,
	check_revision_no TEXT,
	check_serial_no TEXT,
	tc_sm_class TEXT,
	tc_cfg_mode_safe_op INTEGER,
	use_lrd_lwr INTEGER,
	module_pdo_group INTEGER,
	download_module_list INTEGER,
	show_hideable_sub_devices INTEGER,
	invisible INTEGER,
	physics TEXT,
	crc32 INTEGER,
	sci TEXT,
	alternative_types TEXT,
	sub_devices TEXT,
	name TEXT,
	names TEXT,
	comments TEXT,
	urls TEXT,
	e_bus_current_ma INTEGER,
	ether_cat_p TEXT,
	preop_timeout_ms INTEGER,
	safeop_op_timeout_ms INTEGER,
	back_to_init_timeout_ms INTEGER,
	back_to_safeop_timeout_ms INTEGER,
	start_to_init INTEGER,
	start_to_preop INTEGER,
	start_to_safeop INTEGER,
	start_to_safeop_no_sync INTEGER,
	mailbox_request_timeout_ms INTEGER,
	mailbox_response_timeout_ms INTEGER,
	dpram_size INTEGER,
	sm_count INTEGER,
	fmmu_count INTEGER,
	ports TEXT,
	execution_units TEXT,
	station_alias_supported TEXT,
	identification_ado INTEGER,
	identification_reg134 INTEGER,
	device_features TEXT,
	data_rates TEXT,
	dc INTEGER,
	dc_unknown_frmw INTEGER,
	dc_unknown_64bit INTEGER,
	dc_external_ref_clock INTEGER,
	dc_potential_reference_clock INTEGER,
	dc_time_loop_control_only INTEGER,
	dc_pdo_oversampling INTEGER,
	has_slots INTEGER,
	download_module_ident_list INTEGER,
	download_module_address_list INTEGER,
	download_module_list_transition TEXT,
	max_slot_count INTEGER,
	max_slot_group_count INTEGER,
	slot_pdo_increment INTEGER,
	slot_group_pdo_increment INTEGER,
	slot_index_increment INTEGER,
	slot_group_index_increment INTEGER,
	identify_module_by TEXT,
	slot_group_data TEXT,
	module_pdo_groups TEXT,
	slot_selections TEXT,
	esc_reg0108 INTEGER,
	esc_reg0400 INTEGER,
	esc_reg0410 INTEGER,
	esc_reg0420 INTEGER,
	esc_mi45_access TEXT,
	image_symbol TEXT,
	image_file TEXT,
	image_sha256 TEXT,
	spelling TEXT,
	default_op_mode INTEGER,
	element_count INTEGER NOT NULL,
	recovered INTEGER NOT NULL,
	file_version INTEGER,
	group_type TEXT, hidden INTEGER DEFAULT '0' NOT NULL, own_vendor_name TEXT,
	CONSTRAINT pk_devices PRIMARY KEY (id),
	CONSTRAINT fk_devices_vendor_id FOREIGN KEY(vendor_id) REFERENCES vendors (vendor_id),
	CONSTRAINT uq_devices_content_hash UNIQUE (content_hash),
	CONSTRAINT uq_devices_vendor_id_product_code_revision_no_variant UNIQUE (vendor_id, product_code, revision_no, variant)
)
 STRICT;
INSERT INTO "devices" VALUES(1,3676,1,'aed50266730451eac159adf1ad08e339','ECX-D808',218630152,1048576,NULL,NULL,'EQ_OR_G',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'KK',NULL,NULL,NULL,NULL,'ECX-D808 8 digital inputs, 8 digital outputs 24V, 0.5A','[{"text":"ECX-D808 8 digital inputs, 8 digital outputs 24V, 0.5A","lcid":1033},{"text":"ECX-D808 8 digitale Eingänge, 8 digitale Ausgänge 24V, 0,5A","lcid":1031}]',NULL,NULL,100,NULL,2000,9000,5000,200,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,NULL,NULL,NULL,1,NULL,NULL,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'e130ef14b817b46fb13be2c60dd4b03a9619d59d30322ffa8f2af909f29e81bd',NULL,0,16,0,NULL,'EcxDigital',1,NULL);
INSERT INTO "devices" VALUES(2,3676,1,'73a6187b51bd913cb15bd185946671c3','ECX-D808',218630152,1114112,NULL,NULL,'EQ_OR_G',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'KK',NULL,NULL,NULL,NULL,'ECX-D808 8 digital inputs, 8 digital outputs 24V, 0.5A','[{"text":"ECX-D808 8 digital inputs, 8 digital outputs 24V, 0.5A","lcid":1033},{"text":"ECX-D808 8 digitale Eingänge, 8 digitale Ausgänge 24V, 0,5A","lcid":1031}]',NULL,NULL,100,NULL,2000,9000,5000,200,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,NULL,NULL,NULL,1,NULL,NULL,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'e130ef14b817b46fb13be2c60dd4b03a9619d59d30322ffa8f2af909f29e81bd',NULL,0,16,0,NULL,'EcxDigital',0,NULL);
INSERT INTO "devices" VALUES(3,3676,1,'1d9176583da519e70e6519b2b5d40e8e','ECX-A202',41474,65538,NULL,NULL,'HW_EQ_LW_EQ_OR_G',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'YY',NULL,NULL,NULL,NULL,'ECX-A202 two axis servo drive','[{"text":"ECX-A202 two axis servo drive","lcid":1033},{"text":"ECX-A202 Zweiachs-Servoverstärker","lcid":1031}]',NULL,NULL,NULL,NULL,3000,10000,5000,200,NULL,NULL,NULL,1,100,2000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,NULL,NULL,NULL,NULL,NULL,NULL,1,1,NULL,NULL,2,NULL,64,NULL,2048,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"slot_index_increment":"#x800"}',0,152,0,NULL,'EcxDrives',0,NULL);
CREATE TABLE diag_messages (
	id INTEGER NOT NULL,
	diagnostics_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	text_id INTEGER,
	message_texts TEXT,
	descriptions TEXT,
	diag_class TEXT,
	diag_reset INTEGER,
	diag_reaction INTEGER,
	diag_type INTEGER,
	cause_remedies TEXT,
	infos TEXT,
	hints TEXT,
	urls TEXT,
	spelling TEXT,
	CONSTRAINT pk_diag_messages PRIMARY KEY (id),
	CONSTRAINT fk_diag_messages_diagnostics_id FOREIGN KEY(diagnostics_id) REFERENCES diagnostics (id)
)
 STRICT;
CREATE TABLE diagnostics (
	id INTEGER NOT NULL,
	content_hash BLOB NOT NULL,
	diag_resets TEXT,
	diag_reactions TEXT,
	diag_types TEXT,
	spelling TEXT,
	CONSTRAINT pk_diagnostics PRIMARY KEY (id),
	CONSTRAINT uq_diagnostics_content_hash UNIQUE (content_hash)
)
 STRICT;
CREATE TABLE dictionaries (
	id INTEGER NOT NULL,
	content_hash BLOB NOT NULL,
	type_set_id INTEGER NOT NULL,
	unit_types TEXT,
	spelling TEXT,
	object_count INTEGER NOT NULL,
	CONSTRAINT pk_dictionaries PRIMARY KEY (id),
	CONSTRAINT fk_dictionaries_type_set_id FOREIGN KEY(type_set_id) REFERENCES type_sets (id),
	CONSTRAINT uq_dictionaries_content_hash UNIQUE (content_hash)
)
 STRICT;
INSERT INTO "dictionaries" VALUES(1,X'DC3AFE89C0DBF5ECA9E3C0D8DDDA20AE',1,NULL,NULL,27);
INSERT INTO "dictionaries" VALUES(2,X'6B1DFC41B1A814A4B90646B149509874',2,NULL,NULL,24);
INSERT INTO "dictionaries" VALUES(3,X'FC199D6B2D04C648427AD5436CA0A73D',3,NULL,NULL,23);
INSERT INTO "dictionaries" VALUES(4,X'0DAADE793EF09110E98334F17357C786',4,NULL,NULL,23);
INSERT INTO "dictionaries" VALUES(5,X'A355BDFF1239BE1B5EAD984D3ADF7BA4',5,NULL,NULL,18);
CREATE TABLE dictionary_objects (
	dictionary_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	object_id INTEGER NOT NULL,
	CONSTRAINT pk_dictionary_objects PRIMARY KEY (dictionary_id, position),
	CONSTRAINT fk_dictionary_objects_dictionary_id FOREIGN KEY(dictionary_id) REFERENCES dictionaries (id),
	CONSTRAINT fk_dictionary_objects_object_id FOREIGN KEY(object_id) REFERENCES objects (id)
)
 WITHOUT ROWID,
 STRICT;
INSERT INTO "dictionary_objects" VALUES(1,0,1);
INSERT INTO "dictionary_objects" VALUES(1,1,2);
INSERT INTO "dictionary_objects" VALUES(1,2,3);
INSERT INTO "dictionary_objects" VALUES(2,2,3);
INSERT INTO "dictionary_objects" VALUES(3,2,3);
INSERT INTO "dictionary_objects" VALUES(4,2,3);
INSERT INTO "dictionary_objects" VALUES(1,3,4);
INSERT INTO "dictionary_objects" VALUES(2,3,4);
INSERT INTO "dictionary_objects" VALUES(3,3,4);
INSERT INTO "dictionary_objects" VALUES(4,3,4);
INSERT INTO "dictionary_objects" VALUES(1,4,5);
INSERT INTO "dictionary_objects" VALUES(2,4,5);
INSERT INTO "dictionary_objects" VALUES(3,4,5);
INSERT INTO "dictionary_objects" VALUES(4,4,5);
INSERT INTO "dictionary_objects" VALUES(1,5,6);
INSERT INTO "dictionary_objects" VALUES(2,5,6);
INSERT INTO "dictionary_objects" VALUES(3,5,6);
INSERT INTO "dictionary_objects" VALUES(4,5,6);
INSERT INTO "dictionary_objects" VALUES(1,6,7);
INSERT INTO "dictionary_objects" VALUES(2,6,7);
INSERT INTO "dictionary_objects" VALUES(3,6,7);
INSERT INTO "dictionary_objects" VALUES(4,6,7);
INSERT INTO "dictionary_objects" VALUES(1,7,8);
INSERT INTO "dictionary_objects" VALUES(2,7,8);
INSERT INTO "dictionary_objects" VALUES(3,7,8);
INSERT INTO "dictionary_objects" VALUES(4,7,8);
INSERT INTO "dictionary_objects" VALUES(1,8,9);
INSERT INTO "dictionary_objects" VALUES(2,8,9);
INSERT INTO "dictionary_objects" VALUES(3,8,9);
INSERT INTO "dictionary_objects" VALUES(4,8,9);
INSERT INTO "dictionary_objects" VALUES(1,9,10);
INSERT INTO "dictionary_objects" VALUES(1,10,11);
INSERT INTO "dictionary_objects" VALUES(2,9,11);
INSERT INTO "dictionary_objects" VALUES(3,9,11);
INSERT INTO "dictionary_objects" VALUES(4,9,11);
INSERT INTO "dictionary_objects" VALUES(1,11,12);
INSERT INTO "dictionary_objects" VALUES(1,12,13);
INSERT INTO "dictionary_objects" VALUES(1,13,14);
INSERT INTO "dictionary_objects" VALUES(2,11,14);
INSERT INTO "dictionary_objects" VALUES(3,10,14);
INSERT INTO "dictionary_objects" VALUES(4,10,14);
INSERT INTO "dictionary_objects" VALUES(1,14,15);
INSERT INTO "dictionary_objects" VALUES(2,13,15);
INSERT INTO "dictionary_objects" VALUES(3,12,15);
INSERT INTO "dictionary_objects" VALUES(4,12,15);
INSERT INTO "dictionary_objects" VALUES(1,15,16);
INSERT INTO "dictionary_objects" VALUES(2,14,16);
INSERT INTO "dictionary_objects" VALUES(3,14,16);
INSERT INTO "dictionary_objects" VALUES(4,14,16);
INSERT INTO "dictionary_objects" VALUES(1,16,17);
INSERT INTO "dictionary_objects" VALUES(1,17,18);
INSERT INTO "dictionary_objects" VALUES(2,15,18);
INSERT INTO "dictionary_objects" VALUES(3,15,18);
INSERT INTO "dictionary_objects" VALUES(4,15,18);
INSERT INTO "dictionary_objects" VALUES(1,18,19);
INSERT INTO "dictionary_objects" VALUES(2,16,19);
INSERT INTO "dictionary_objects" VALUES(3,16,19);
INSERT INTO "dictionary_objects" VALUES(4,16,19);
INSERT INTO "dictionary_objects" VALUES(1,19,20);
INSERT INTO "dictionary_objects" VALUES(2,17,20);
INSERT INTO "dictionary_objects" VALUES(3,18,20);
INSERT INTO "dictionary_objects" VALUES(4,18,20);
INSERT INTO "dictionary_objects" VALUES(1,20,21);
INSERT INTO "dictionary_objects" VALUES(1,21,22);
INSERT INTO "dictionary_objects" VALUES(2,18,22);
INSERT INTO "dictionary_objects" VALUES(1,22,23);
INSERT INTO "dictionary_objects" VALUES(2,19,23);
INSERT INTO "dictionary_objects" VALUES(3,19,23);
INSERT INTO "dictionary_objects" VALUES(1,23,24);
INSERT INTO "dictionary_objects" VALUES(2,20,24);
INSERT INTO "dictionary_objects" VALUES(3,20,24);
INSERT INTO "dictionary_objects" VALUES(4,19,24);
INSERT INTO "dictionary_objects" VALUES(1,24,25);
INSERT INTO "dictionary_objects" VALUES(1,25,26);
INSERT INTO "dictionary_objects" VALUES(2,22,26);
INSERT INTO "dictionary_objects" VALUES(3,21,26);
INSERT INTO "dictionary_objects" VALUES(4,21,26);
INSERT INTO "dictionary_objects" VALUES(1,26,27);
INSERT INTO "dictionary_objects" VALUES(2,23,27);
INSERT INTO "dictionary_objects" VALUES(3,22,27);
INSERT INTO "dictionary_objects" VALUES(4,22,27);
INSERT INTO "dictionary_objects" VALUES(2,0,28);
INSERT INTO "dictionary_objects" VALUES(2,1,29);
INSERT INTO "dictionary_objects" VALUES(2,10,30);
INSERT INTO "dictionary_objects" VALUES(2,12,31);
INSERT INTO "dictionary_objects" VALUES(2,21,32);
INSERT INTO "dictionary_objects" VALUES(3,0,33);
INSERT INTO "dictionary_objects" VALUES(3,1,34);
INSERT INTO "dictionary_objects" VALUES(3,11,35);
INSERT INTO "dictionary_objects" VALUES(4,11,35);
INSERT INTO "dictionary_objects" VALUES(3,13,36);
INSERT INTO "dictionary_objects" VALUES(4,13,36);
INSERT INTO "dictionary_objects" VALUES(3,17,37);
INSERT INTO "dictionary_objects" VALUES(4,17,37);
INSERT INTO "dictionary_objects" VALUES(4,0,38);
INSERT INTO "dictionary_objects" VALUES(4,1,39);
INSERT INTO "dictionary_objects" VALUES(4,20,40);
INSERT INTO "dictionary_objects" VALUES(5,0,41);
INSERT INTO "dictionary_objects" VALUES(5,1,42);
INSERT INTO "dictionary_objects" VALUES(5,2,43);
INSERT INTO "dictionary_objects" VALUES(5,3,44);
INSERT INTO "dictionary_objects" VALUES(5,4,45);
INSERT INTO "dictionary_objects" VALUES(5,5,46);
INSERT INTO "dictionary_objects" VALUES(5,6,47);
INSERT INTO "dictionary_objects" VALUES(5,7,48);
INSERT INTO "dictionary_objects" VALUES(5,8,49);
INSERT INTO "dictionary_objects" VALUES(5,9,50);
INSERT INTO "dictionary_objects" VALUES(5,10,51);
INSERT INTO "dictionary_objects" VALUES(5,11,52);
INSERT INTO "dictionary_objects" VALUES(5,12,53);
INSERT INTO "dictionary_objects" VALUES(5,13,54);
INSERT INTO "dictionary_objects" VALUES(5,14,55);
INSERT INTO "dictionary_objects" VALUES(5,15,56);
INSERT INTO "dictionary_objects" VALUES(5,16,57);
INSERT INTO "dictionary_objects" VALUES(5,17,58);
CREATE TABLE drive_modes (
	device_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	axis INTEGER,
	mode TEXT,
	kind TEXT,
	verdict TEXT,
	score REAL,
	"conflict" INTEGER,
	evidence TEXT,
	module_ident INTEGER,
	module_is_default INTEGER,
	rx_pdo_index INTEGER,
	rx_pdo_is_default INTEGER,
	op_mode TEXT,
	recipe TEXT,
	CONSTRAINT pk_drive_modes PRIMARY KEY (device_id, position),
	CONSTRAINT fk_drive_modes_device_id FOREIGN KEY(device_id) REFERENCES devices (id)
)
 WITHOUT ROWID,
 STRICT;
INSERT INTO "drive_modes" VALUES(3,0,0,'PP','CiA 402','possible',0.25,0,'0x607A can be mapped into an RxPDO',67584,1,5888,1,'DC','plug module 0x10800 into slot 0 (default); RxPDO 0x1700 maps the setpoint; OpMode ''DC''; 0x6060 is in none of the assigned RxPDOs: write 1 to it before operation, after the InitCmd that writes 8');
INSERT INTO "drive_modes" VALUES(3,1,0,'PV','CiA 402','possible',0.25,0,'0x60FF can be mapped into an RxPDO',67840,0,5889,1,'DC','plug module 0x10900 into slot 0 (not the default); RxPDO 0x1701 maps the setpoint; OpMode ''DC''; 0x6060 is in none of the assigned RxPDOs: write 3 to it before operation, after the InitCmd that writes 9');
INSERT INTO "drive_modes" VALUES(3,2,0,'TQ','CiA 402','possible',0.25,0,'0x6071 can be mapped into an RxPDO',68096,0,5890,1,'DC','plug module 0x10A00 into slot 0 (not the default, or 0x10B00); RxPDO 0x1702 maps the setpoint; OpMode ''DC''; 0x6060 is in none of the assigned RxPDOs: write 4 to it before operation, after the InitCmd that writes 10');
INSERT INTO "drive_modes" VALUES(3,3,0,'CSP','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6060 = 8 (CSP); RxPDO 0x1700 maps its setpoint 0x607A',67584,1,5888,1,'DC','plug module 0x10800 into slot 0 (default); RxPDO 0x1700 maps the setpoint; OpMode ''DC''; 0x6060 = 8 is written by an InitCmd');
INSERT INTO "drive_modes" VALUES(3,4,0,'CSV','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6060 = 9 (CSV); RxPDO 0x1701 maps its setpoint 0x60FF',67840,0,5889,1,'DC','plug module 0x10900 into slot 0 (not the default); RxPDO 0x1701 maps the setpoint; OpMode ''DC''; 0x6060 = 9 is written by an InitCmd');
INSERT INTO "drive_modes" VALUES(3,5,0,'CST','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6060 = 10 (CST); RxPDO 0x1702 maps its setpoint 0x6071',68096,0,5890,1,'DC','plug module 0x10A00 into slot 0 (not the default); RxPDO 0x1702 maps the setpoint; OpMode ''DC''; 0x6060 = 10 is written by an InitCmd');
INSERT INTO "drive_modes" VALUES(3,6,0,'CSTCA','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6060 = 11 (CSTCA); RxPDO 0x1703 maps its setpoint 0x6071 and 0x60EA',68352,0,5891,1,'DC','plug module 0x10B00 into slot 0 (not the default); RxPDO 0x1703 maps the setpoint; OpMode ''DC''; 0x6060 = 11 is written by an InitCmd');
INSERT INTO "drive_modes" VALUES(3,7,1,'PP','CiA 402','possible',0.25,0,'0x687A can be mapped into an RxPDO',67584,1,5952,1,'DC','plug module 0x10800 into slot 1 (default); RxPDO 0x1740 maps the setpoint; OpMode ''DC''; 0x6860 is in none of the assigned RxPDOs: write 1 to it before operation, after the InitCmd that writes 8');
INSERT INTO "drive_modes" VALUES(3,8,1,'PV','CiA 402','possible',0.25,0,'0x68FF can be mapped into an RxPDO',67840,0,5953,1,'DC','plug module 0x10900 into slot 1 (not the default); RxPDO 0x1741 maps the setpoint; OpMode ''DC''; 0x6860 is in none of the assigned RxPDOs: write 3 to it before operation, after the InitCmd that writes 9');
INSERT INTO "drive_modes" VALUES(3,9,1,'TQ','CiA 402','possible',0.25,0,'0x6871 can be mapped into an RxPDO',68096,0,5954,1,'DC','plug module 0x10A00 into slot 1 (not the default, or 0x10B00); RxPDO 0x1742 maps the setpoint; OpMode ''DC''; 0x6860 is in none of the assigned RxPDOs: write 4 to it before operation, after the InitCmd that writes 10');
INSERT INTO "drive_modes" VALUES(3,10,1,'CSP','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6860 = 8 (CSP); RxPDO 0x1740 maps its setpoint 0x687A',67584,1,5952,1,'DC','plug module 0x10800 into slot 1 (default); RxPDO 0x1740 maps the setpoint; OpMode ''DC''; 0x6860 = 8 is written by an InitCmd');
INSERT INTO "drive_modes" VALUES(3,11,1,'CSV','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6860 = 9 (CSV); RxPDO 0x1741 maps its setpoint 0x68FF',67840,0,5953,1,'DC','plug module 0x10900 into slot 1 (not the default); RxPDO 0x1741 maps the setpoint; OpMode ''DC''; 0x6860 = 9 is written by an InitCmd');
INSERT INTO "drive_modes" VALUES(3,12,1,'CST','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6860 = 10 (CST); RxPDO 0x1742 maps its setpoint 0x6871',68096,0,5954,1,'DC','plug module 0x10A00 into slot 1 (not the default); RxPDO 0x1742 maps the setpoint; OpMode ''DC''; 0x6860 = 10 is written by an InitCmd');
INSERT INTO "drive_modes" VALUES(3,13,1,'CSTCA','CiA 402','yes',0.9,0,'InitCmd PS writes 0x6860 = 11 (CSTCA); RxPDO 0x1743 maps its setpoint 0x6871 and 0x68EA',68352,0,5955,1,'DC','plug module 0x10B00 into slot 1 (not the default); RxPDO 0x1743 maps the setpoint; OpMode ''DC''; 0x6860 = 11 is written by an InitCmd');
CREATE TABLE eeproms (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	assign_to_pdi INTEGER,
	data TEXT,
	byte_size INTEGER,
	config_data TEXT,
	config_data2 TEXT,
	boot_strap TEXT,
	categories TEXT,
	spelling TEXT,
	CONSTRAINT pk_eeproms PRIMARY KEY (id),
	CONSTRAINT ck_eeproms_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_eeproms_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_eeproms_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "eeproms" VALUES(1,1,NULL,0,NULL,NULL,2048,'040C00EE6400F000',NULL,NULL,NULL,NULL);
INSERT INTO "eeproms" VALUES(2,2,NULL,0,NULL,NULL,2048,'040C00EE6400F000',NULL,NULL,NULL,NULL);
INSERT INTO "eeproms" VALUES(3,3,NULL,0,NULL,NULL,4096,'050C03EE0A000000',NULL,'0010000100120001',NULL,NULL);
CREATE TABLE enum_values (
	id INTEGER NOT NULL,
	data_type_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	texts TEXT,
	value INTEGER,
	comments TEXT,
	spelling TEXT,
	CONSTRAINT pk_enum_values PRIMARY KEY (id),
	CONSTRAINT fk_enum_values_data_type_id FOREIGN KEY(data_type_id) REFERENCES data_types (id)
)
 STRICT;
CREATE TABLE findings (
	id INTEGER NOT NULL,
	source_id INTEGER NOT NULL,
	rule TEXT NOT NULL,
	severity TEXT NOT NULL,
	message TEXT NOT NULL,
	line INTEGER NOT NULL,
	path TEXT NOT NULL,
	CONSTRAINT pk_findings PRIMARY KEY (id),
	CONSTRAINT fk_findings_source_id FOREIGN KEY(source_id) REFERENCES sources (id)
)
 STRICT;
CREATE TABLE fmmus (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	usage TEXT,
	op_only INTEGER,
	sm INTEGER,
	su INTEGER,
	spelling TEXT,
	CONSTRAINT pk_fmmus PRIMARY KEY (id),
	CONSTRAINT ck_fmmus_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_fmmus_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_fmmus_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "fmmus" VALUES(1,1,NULL,0,'Outputs',NULL,NULL,NULL,NULL);
INSERT INTO "fmmus" VALUES(2,1,NULL,1,'Inputs',NULL,NULL,NULL,NULL);
INSERT INTO "fmmus" VALUES(3,2,NULL,0,'Outputs',NULL,NULL,NULL,NULL);
INSERT INTO "fmmus" VALUES(4,2,NULL,1,'Inputs',NULL,NULL,NULL,NULL);
INSERT INTO "fmmus" VALUES(5,3,NULL,0,'Outputs',NULL,NULL,NULL,NULL);
INSERT INTO "fmmus" VALUES(6,3,NULL,1,'Inputs',NULL,NULL,NULL,NULL);
INSERT INTO "fmmus" VALUES(7,3,NULL,2,'MBoxState',NULL,NULL,NULL,NULL);
CREATE TABLE groups (
	id INTEGER NOT NULL,
	vendor_id INTEGER,
	content_hash TEXT NOT NULL,
	type TEXT,
	name TEXT,
	names TEXT,
	comments TEXT,
	sort_order INTEGER,
	parent_group TEXT,
	image_symbol TEXT,
	image_file TEXT,
	image_sha256 TEXT,
	vendor_specific TEXT,
	spelling TEXT,
	CONSTRAINT pk_groups PRIMARY KEY (id),
	CONSTRAINT uq_groups_content_hash UNIQUE (content_hash)
)
 STRICT;
INSERT INTO "groups" VALUES(1,3676,'dac126f9f524c928bb83652761815a62','EcxTerm','ECX terminals','[{"text":"ECX terminals","lcid":1033},{"text":"ECX-Klemmen","lcid":1031}]',NULL,10,NULL,NULL,NULL,'e130ef14b817b46fb13be2c60dd4b03a9619d59d30322ffa8f2af909f29e81bd',NULL,NULL);
INSERT INTO "groups" VALUES(2,3676,'154531648a1d4025e9e1e6add6008789','EcxDigital','Digital terminals (ECX-Dxxx)','[{"text":"Digital terminals (ECX-Dxxx)","lcid":1033},{"text":"Digitalklemmen (ECX-Dxxx)","lcid":1031}]',NULL,11,'EcxTerm',NULL,NULL,NULL,NULL,NULL);
INSERT INTO "groups" VALUES(3,3676,'6206e747bc67844ba604e062e6582a8b','EcxDrives','ECX servo drives','[{"text":"ECX servo drives","lcid":1033}]',NULL,20,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE hidden_revisions (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	text TEXT,
	product_code INTEGER,
	revision_no INTEGER,
	product_revision TEXT,
	spelling TEXT,
	CONSTRAINT pk_hidden_revisions PRIMARY KEY (id),
	CONSTRAINT ck_hidden_revisions_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_hidden_revisions_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_hidden_revisions_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "hidden_revisions" VALUES(1,2,NULL,0,'',NULL,1048576,NULL,NULL);
CREATE TABLE images (
	sha256 TEXT NOT NULL,
	data BLOB,
	malformed TEXT,
	CONSTRAINT pk_images PRIMARY KEY (sha256)
)
 STRICT;
INSERT INTO "images" VALUES('e130ef14b817b46fb13be2c60dd4b03a9619d59d30322ffa8f2af909f29e81bd',X'424DD6020000000000003600000028000000100000000E0000000100180000000000A0020000130B0000130B00000000000000000000FF00FFFF00FFFF00FFFF00FF3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEEBEBEBBEBEBEBEBEBEEBEBEBBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEEBEBEBBEBEBEBEBEBEEBEBEBBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEEBEBEBBEBEBEBEBEBEEBEBEBBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CC85A28C85A28C85A28C85A28C85A28C85A283C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBE14B414BEBEBEBEBEBE285A28BEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBE285A28BEBEBEBEBEBE14B414BEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3CBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBEBE3C3C3CFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FFFF00FF3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3C3CFF00FFFF00FFFF00FFFF00FF',NULL);
CREATE TABLE initcmds (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	protocol TEXT NOT NULL,
	transitions TEXT,
	object_index INTEGER,
	depend_on_slot INTEGER,
	depend_on_slot_group INTEGER,
	subindex INTEGER,
	idn INTEGER,
	channel INTEGER,
	eoe_type INTEGER,
	data TEXT,
	adapt_automatically INTEGER,
	comment TEXT,
	fixed INTEGER,
	complete_access INTEGER,
	overwritten_by_module INTEGER,
	spelling TEXT,
	CONSTRAINT pk_initcmds PRIMARY KEY (id),
	CONSTRAINT ck_initcmds_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_initcmds_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_initcmds_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "initcmds" VALUES(1,NULL,1,0,'CoE','["PS"]',24672,1,NULL,0,NULL,NULL,NULL,'08',NULL,'Modes of operation: CSP',NULL,NULL,NULL,'{"depend_on_slot":"true"}');
INSERT INTO "initcmds" VALUES(2,NULL,2,0,'CoE','["PS"]',24672,1,NULL,0,NULL,NULL,NULL,'09',NULL,'Modes of operation: CSV',NULL,NULL,NULL,'{"depend_on_slot":"true"}');
INSERT INTO "initcmds" VALUES(3,NULL,3,0,'CoE','["PS"]',24672,1,NULL,0,NULL,NULL,NULL,'0A',NULL,'Modes of operation: CST',NULL,NULL,NULL,'{"depend_on_slot":"true"}');
INSERT INTO "initcmds" VALUES(4,NULL,4,0,'CoE','["PS"]',24672,1,NULL,0,NULL,NULL,NULL,'0B',NULL,'Modes of operation: CSTCA',NULL,NULL,NULL,'{"depend_on_slot":"true"}');
CREATE TABLE mailboxes (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	data_link_layer INTEGER,
	real_time_mode INTEGER,
	aoe INTEGER,
	aoe_ads_router INTEGER,
	aoe_generate_own_net_id INTEGER,
	aoe_initialize_own_net_id INTEGER,
	eoe INTEGER,
	eoe_ip INTEGER,
	eoe_mac INTEGER,
	eoe_time_stamp INTEGER,
	coe INTEGER,
	coe_sdo_info INTEGER,
	coe_pdo_assign INTEGER,
	coe_pdo_config INTEGER,
	coe_pdo_upload INTEGER,
	coe_complete_access INTEGER,
	coe_segmented_sdo INTEGER,
	coe_diag_history INTEGER,
	coe_sdo_upload_with_max_length INTEGER,
	coe_time_distribution INTEGER,
	coe_module_od INTEGER,
	coe_eds_file TEXT,
	coe_ds402_channels INTEGER,
	coe_objects TEXT,
	foe INTEGER,
	soe INTEGER,
	soe_channel_count INTEGER,
	soe_drive_follows_bit3 INTEGER,
	soe_diag_files TEXT,
	soe_diag_messages TEXT,
	voe INTEGER,
	spelling TEXT,
	CONSTRAINT pk_mailboxes PRIMARY KEY (id),
	CONSTRAINT ck_mailboxes_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_mailboxes_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_mailboxes_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "mailboxes" VALUES(1,NULL,1,0,NULL,NULL,0,NULL,NULL,NULL,0,NULL,NULL,NULL,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,0,0,NULL,NULL,NULL,NULL,0,NULL);
INSERT INTO "mailboxes" VALUES(2,NULL,2,0,NULL,NULL,0,NULL,NULL,NULL,0,NULL,NULL,NULL,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,0,0,NULL,NULL,NULL,NULL,0,NULL);
INSERT INTO "mailboxes" VALUES(3,NULL,3,0,NULL,NULL,0,NULL,NULL,NULL,0,NULL,NULL,NULL,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,0,0,NULL,NULL,NULL,NULL,0,NULL);
INSERT INTO "mailboxes" VALUES(4,NULL,4,0,NULL,NULL,0,NULL,NULL,NULL,0,NULL,NULL,NULL,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,0,0,NULL,NULL,NULL,NULL,0,NULL);
INSERT INTO "mailboxes" VALUES(5,3,NULL,0,1,NULL,0,NULL,NULL,NULL,0,NULL,NULL,NULL,1,1,1,0,NULL,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,0,NULL,NULL,NULL,NULL,0,NULL);
CREATE TABLE mode_evidence (
	device_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	axis INTEGER,
	module_ident INTEGER,
	mode TEXT,
	rank TEXT,
	wording TEXT,
	score REAL,
	polarity TEXT,
	"conflict" INTEGER,
	object_index INTEGER,
	pdo_index INTEGER,
	evidence TEXT,
	CONSTRAINT pk_mode_evidence PRIMARY KEY (device_id, position),
	CONSTRAINT fk_mode_evidence_device_id FOREIGN KEY(device_id) REFERENCES devices (id)
)
 WITHOUT ROWID,
 STRICT;
INSERT INTO "mode_evidence" VALUES(3,0,0,67584,'CSP','C1','named',0.8,'yes',0,NULL,5888,'module name ''CSP / Cyclic synchronous position mode (CSP)'' names CSP; RxPDO 0x1700 maps 0x607A');
INSERT INTO "mode_evidence" VALUES(3,1,0,67584,'CSP','C1','named',0.8,'yes',0,NULL,5888,'RxPDO 0x1700 ''CSP outputs'' names CSP and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,2,0,67584,'CSP','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5888,'RxPDO 0x1700 maps 0x607A, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,3,0,67584,'PP','E','inferred from the dictionary',0.25,'yes',0,24698,NULL,'0x607A can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,4,0,67584,'CSP','E','inferred from the dictionary',0.25,'yes',0,24698,NULL,'0x607A can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,5,0,67584,'CSP','B1','configured by InitCmd',0.9,'yes',0,24672,5888,'InitCmd PS writes 0x6060 = 8 (CSP); RxPDO 0x1700 maps its setpoint 0x607A');
INSERT INTO "mode_evidence" VALUES(3,6,0,67840,'CSV','C1','named',0.8,'yes',0,NULL,5889,'module name ''CSV / Cyclic synchronous velocity mode (CSV)'' names CSV; RxPDO 0x1701 maps 0x60FF');
INSERT INTO "mode_evidence" VALUES(3,7,0,67840,'CSV','C1','named',0.8,'yes',0,NULL,5889,'RxPDO 0x1701 ''CSV outputs'' names CSV and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,8,0,67840,'CSV','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5889,'RxPDO 0x1701 maps 0x60FF, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,9,0,67840,'PV','E','inferred from the dictionary',0.25,'yes',0,24831,NULL,'0x60FF can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,10,0,67840,'CSV','E','inferred from the dictionary',0.25,'yes',0,24831,NULL,'0x60FF can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,11,0,67840,'CSV','B1','configured by InitCmd',0.9,'yes',0,24672,5889,'InitCmd PS writes 0x6060 = 9 (CSV); RxPDO 0x1701 maps its setpoint 0x60FF');
INSERT INTO "mode_evidence" VALUES(3,12,0,68096,'CST','C1','named',0.8,'yes',0,NULL,5890,'module name ''CST / Cyclic synchronous torque mode (CST)'' names CST; RxPDO 0x1702 maps 0x6071');
INSERT INTO "mode_evidence" VALUES(3,13,0,68096,'CST','C1','named',0.8,'yes',0,NULL,5890,'RxPDO 0x1702 ''CST outputs'' names CST and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,14,0,68096,'CST','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5890,'RxPDO 0x1702 maps 0x6071, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,15,0,68096,'TQ','E','inferred from the dictionary',0.25,'yes',0,24689,NULL,'0x6071 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,16,0,68096,'CST','E','inferred from the dictionary',0.25,'yes',0,24689,NULL,'0x6071 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,17,0,68096,'CST','B1','configured by InitCmd',0.9,'yes',0,24672,5890,'InitCmd PS writes 0x6060 = 10 (CST); RxPDO 0x1702 maps its setpoint 0x6071');
INSERT INTO "mode_evidence" VALUES(3,18,0,68352,'CSTCA','C1','named',0.8,'yes',0,NULL,5891,'module name ''CSTCA / Cyclic synchronous torque mode with commutation angle (CSTCA)'' names CSTCA; RxPDO 0x1703 maps 0x6071 and 0x60EA');
INSERT INTO "mode_evidence" VALUES(3,19,0,68352,'CSTCA','C1','named',0.8,'yes',0,NULL,5891,'RxPDO 0x1703 ''CSTCA outputs'' names CSTCA and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,20,0,68352,'CST','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5891,'RxPDO 0x1703 maps 0x6071, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,21,0,68352,'TQ','E','inferred from the dictionary',0.25,'yes',0,24689,NULL,'0x6071 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,22,0,68352,'CST','E','inferred from the dictionary',0.25,'yes',0,24689,NULL,'0x6071 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,23,0,68352,'CSTCA','B1','configured by InitCmd',0.9,'yes',0,24672,5891,'InitCmd PS writes 0x6060 = 11 (CSTCA); RxPDO 0x1703 maps its setpoint 0x6071 and 0x60EA');
INSERT INTO "mode_evidence" VALUES(3,24,1,67584,'CSP','C1','named',0.8,'yes',0,NULL,5952,'module name ''CSP / Cyclic synchronous position mode (CSP)'' names CSP; RxPDO 0x1740 maps 0x687A');
INSERT INTO "mode_evidence" VALUES(3,25,1,67584,'CSP','C1','named',0.8,'yes',0,NULL,5952,'RxPDO 0x1740 ''CSP outputs'' names CSP and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,26,1,67584,'CSP','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5952,'RxPDO 0x1740 maps 0x687A, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,27,1,67584,'PP','E','inferred from the dictionary',0.25,'yes',0,26746,NULL,'0x687A can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,28,1,67584,'CSP','E','inferred from the dictionary',0.25,'yes',0,26746,NULL,'0x687A can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,29,1,67584,'CSP','B1','configured by InitCmd',0.9,'yes',0,26720,5952,'InitCmd PS writes 0x6860 = 8 (CSP); RxPDO 0x1740 maps its setpoint 0x687A');
INSERT INTO "mode_evidence" VALUES(3,30,1,67840,'CSV','C1','named',0.8,'yes',0,NULL,5953,'module name ''CSV / Cyclic synchronous velocity mode (CSV)'' names CSV; RxPDO 0x1741 maps 0x68FF');
INSERT INTO "mode_evidence" VALUES(3,31,1,67840,'CSV','C1','named',0.8,'yes',0,NULL,5953,'RxPDO 0x1741 ''CSV outputs'' names CSV and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,32,1,67840,'CSV','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5953,'RxPDO 0x1741 maps 0x68FF, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,33,1,67840,'PV','E','inferred from the dictionary',0.25,'yes',0,26879,NULL,'0x68FF can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,34,1,67840,'CSV','E','inferred from the dictionary',0.25,'yes',0,26879,NULL,'0x68FF can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,35,1,67840,'CSV','B1','configured by InitCmd',0.9,'yes',0,26720,5953,'InitCmd PS writes 0x6860 = 9 (CSV); RxPDO 0x1741 maps its setpoint 0x68FF');
INSERT INTO "mode_evidence" VALUES(3,36,1,68096,'CST','C1','named',0.8,'yes',0,NULL,5954,'module name ''CST / Cyclic synchronous torque mode (CST)'' names CST; RxPDO 0x1742 maps 0x6871');
INSERT INTO "mode_evidence" VALUES(3,37,1,68096,'CST','C1','named',0.8,'yes',0,NULL,5954,'RxPDO 0x1742 ''CST outputs'' names CST and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,38,1,68096,'CST','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5954,'RxPDO 0x1742 maps 0x6871, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,39,1,68096,'TQ','E','inferred from the dictionary',0.25,'yes',0,26737,NULL,'0x6871 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,40,1,68096,'CST','E','inferred from the dictionary',0.25,'yes',0,26737,NULL,'0x6871 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,41,1,68096,'CST','B1','configured by InitCmd',0.9,'yes',0,26720,5954,'InitCmd PS writes 0x6860 = 10 (CST); RxPDO 0x1742 maps its setpoint 0x6871');
INSERT INTO "mode_evidence" VALUES(3,42,1,68352,'CSTCA','C1','named',0.8,'yes',0,NULL,5955,'module name ''CSTCA / Cyclic synchronous torque mode with commutation angle (CSTCA)'' names CSTCA; RxPDO 0x1743 maps 0x6871 and 0x68EA');
INSERT INTO "mode_evidence" VALUES(3,43,1,68352,'CSTCA','C1','named',0.8,'yes',0,NULL,5955,'RxPDO 0x1743 ''CSTCA outputs'' names CSTCA and maps its setpoint');
INSERT INTO "mode_evidence" VALUES(3,44,1,68352,'CST','D1','inferred from setpoint and DC',0.6,'yes',0,NULL,5955,'RxPDO 0x1743 maps 0x6871, and a DC OpMode generates SYNC0');
INSERT INTO "mode_evidence" VALUES(3,45,1,68352,'TQ','E','inferred from the dictionary',0.25,'yes',0,26737,NULL,'0x6871 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,46,1,68352,'CST','E','inferred from the dictionary',0.25,'yes',0,26737,NULL,'0x6871 can be mapped into an RxPDO');
INSERT INTO "mode_evidence" VALUES(3,47,1,68352,'CSTCA','B1','configured by InitCmd',0.9,'yes',0,26720,5955,'InitCmd PS writes 0x6860 = 11 (CSTCA); RxPDO 0x1743 maps its setpoint 0x6871 and 0x68EA');
CREATE TABLE module_sources (
	id INTEGER NOT NULL,
	module_id INTEGER NOT NULL,
	source_id INTEGER NOT NULL,
	section INTEGER NOT NULL,
	position INTEGER NOT NULL,
	line INTEGER NOT NULL,
	CONSTRAINT pk_module_sources PRIMARY KEY (id),
	CONSTRAINT fk_module_sources_module_id FOREIGN KEY(module_id) REFERENCES modules (id),
	CONSTRAINT fk_module_sources_source_id FOREIGN KEY(source_id) REFERENCES sources (id)
)
 STRICT;
INSERT INTO "module_sources" VALUES(1,1,2,0,0,1017);
INSERT INTO "module_sources" VALUES(2,2,2,0,1,1706);
INSERT INTO "module_sources" VALUES(3,3,2,0,2,2329);
INSERT INTO "module_sources" VALUES(4,4,2,0,3,2926);
CREATE TABLE modules (
	id INTEGER NOT NULL,
	vendor_id INTEGER,
	content_hash TEXT NOT NULL,
	type TEXT,
	module_ident INTEGER,
	module_class TEXT,
	module_pdo_group INTEGER,
	sra_parameter_supported INTEGER,
	crc32 INTEGER,
	name TEXT,
	names TEXT,
	dc_op_mode_name TEXT,
	image_symbol TEXT,
	image_file TEXT,
	image_sha256 TEXT,
	spelling TEXT,
	element_count INTEGER NOT NULL,
	CONSTRAINT pk_modules PRIMARY KEY (id),
	CONSTRAINT fk_modules_vendor_id FOREIGN KEY(vendor_id) REFERENCES vendors (vendor_id),
	CONSTRAINT uq_modules_content_hash UNIQUE (content_hash)
)
 STRICT;
INSERT INTO "modules" VALUES(1,3676,'3ff128e35de26f019c777d51782d81d6','CSP',67584,NULL,NULL,NULL,NULL,'Cyclic synchronous position mode (CSP)','[{"text":"Cyclic synchronous position mode (CSP)","lcid":1033}]','DC',NULL,NULL,NULL,NULL,38);
INSERT INTO "modules" VALUES(2,3676,'02558542a93aa5dcdd0d76e9b539e1c9','CSV',67840,NULL,NULL,NULL,NULL,'Cyclic synchronous velocity mode (CSV)','[{"text":"Cyclic synchronous velocity mode (CSV)","lcid":1033}]','DC',NULL,NULL,NULL,NULL,33);
INSERT INTO "modules" VALUES(3,3676,'be4185650e4b291acb0e5afbed1f6239','CST',68096,NULL,NULL,NULL,NULL,'Cyclic synchronous torque mode (CST)','[{"text":"Cyclic synchronous torque mode (CST)","lcid":1033}]','DC',NULL,NULL,NULL,NULL,31);
INSERT INTO "modules" VALUES(4,3676,'a7ee32c1f752dadbbc5f7ec2cbf96995','CSTCA',68352,NULL,NULL,NULL,NULL,'Cyclic synchronous torque mode with commutation angle (CSTCA)','[{"text":"Cyclic synchronous torque mode with commutation angle (CSTCA)","lcid":1033}]','DC',NULL,NULL,NULL,NULL,32);
CREATE TABLE object_entries (
	id INTEGER NOT NULL,
	object_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	subindex INTEGER,
	name TEXT,
	data_type TEXT,
	base_type TEXT,
	bit_size INTEGER,
	bit_offset INTEGER,
	access TEXT,
	access_word INTEGER,
	category TEXT,
	pdo_mapping TEXT,
	safety_mapping TEXT,
	default_raw TEXT,
	default_kind TEXT,
	default_int INTEGER,
	default_real REAL,
	default_text TEXT,
	min_int INTEGER,
	min_real REAL,
	max_int INTEGER,
	max_real REAL,
	unit INTEGER,
	display_name TEXT,
	CONSTRAINT pk_object_entries PRIMARY KEY (id),
	CONSTRAINT fk_object_entries_object_id FOREIGN KEY(object_id) REFERENCES objects (id)
)
 STRICT;
INSERT INTO "object_entries" VALUES(1,1,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'04','data',4,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(2,1,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(3,1,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(4,1,3,3,'SubIndex 003','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(5,1,4,4,'SubIndex 004','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(6,2,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'07','data',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(7,2,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(8,2,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(9,2,3,3,'SubIndex 003','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(10,2,4,4,'SubIndex 004','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(11,2,5,5,'SubIndex 005','UDINT','UDINT',32,144,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(12,2,6,6,'SubIndex 006','UDINT','UDINT',32,176,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(13,2,7,7,'SubIndex 007','UDINT','UDINT',32,208,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(14,3,0,0,'Error code','UINT','UINT',16,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(15,4,0,0,'Controlword','UINT','UINT',16,0,'rw',127,'m','R',NULL,'0000','data',0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(16,5,0,0,'Statusword','UINT','UINT',16,0,'ro',135,'m','T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(17,6,0,0,'Quick stop option code','INT','INT',16,0,'rw',63,NULL,NULL,NULL,'0200','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(18,7,0,0,'Fault reaction option code','INT','INT',16,0,'rw',63,NULL,NULL,NULL,'0200','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(19,8,0,0,'Modes of operation','SINT','SINT',8,0,'rw',127,'m','R',NULL,'00','data',0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(20,9,0,0,'Modes of operation display','SINT','SINT',8,0,'ro',135,'m','T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(21,10,0,0,'Position demand value','DINT','DINT',32,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(22,11,0,0,'Position actual value','DINT','DINT',32,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(23,12,0,0,'Following error window','UDINT','UDINT',32,0,'rw',63,NULL,NULL,NULL,'A00F0000','data',4000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(24,13,0,0,'Position window','UDINT','UDINT',32,0,'rw',63,NULL,NULL,NULL,'0A000000','data',10,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(25,14,0,0,'Velocity actual value','DINT','DINT',32,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(26,15,0,0,'Max torque','UINT','UINT',16,0,'rw',127,NULL,'R',NULL,'B80B','data',3000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(27,16,0,0,'Torque actual value','INT','INT',16,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(28,17,0,0,'Target position','DINT','DINT',32,0,'rw',127,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(29,18,0,0,'Max motor speed','UDINT','UDINT',32,0,'rw',127,NULL,'R',NULL,'70170000','data',6000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(30,19,0,0,'Quick stop deceleration','UDINT','UDINT',32,0,'rw',63,NULL,NULL,NULL,'A0860100','data',100000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(31,20,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(32,20,1,1,'Encoder increments','UDINT','UDINT',32,16,'rw',63,NULL,NULL,NULL,'00001000','data',1048576,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(33,20,2,2,'Motor revolutions','UDINT','UDINT',32,48,'rw',63,NULL,NULL,NULL,'01000000','data',1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(34,21,0,0,'Position offset','DINT','DINT',32,0,'rw',127,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(35,22,0,0,'Velocity offset','DINT','DINT',32,0,'rw',127,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(36,23,0,0,'Torque offset','INT','INT',16,0,'rw',127,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(37,24,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(38,24,1,1,'Interpolation time period value','USINT','USINT',8,16,'rw',63,NULL,NULL,NULL,'01','data',1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(39,24,2,2,'Interpolation time index','SINT','SINT',8,24,'rw',63,NULL,NULL,NULL,'FD','data',-3,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(40,25,0,0,'Following error actual value','DINT','DINT',32,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(41,26,0,0,'Motor type','UINT','UINT',16,0,'rw',63,NULL,NULL,NULL,'0300','data',3,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(42,27,0,0,'Supported drive modes','UDINT','UDINT',32,0,'ro',7,'m',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(43,28,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'03','data',3,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(44,28,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(45,28,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(46,28,3,3,'SubIndex 003','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(47,29,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'06','data',6,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(48,29,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(49,29,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(50,29,3,3,'SubIndex 003','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(51,29,4,4,'SubIndex 004','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(52,29,5,5,'SubIndex 005','UDINT','UDINT',32,144,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(53,29,6,6,'SubIndex 006','UDINT','UDINT',32,176,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(54,30,0,0,'Velocity demand value','DINT','DINT',32,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(55,31,0,0,'Velocity window','UINT','UINT',16,0,'rw',63,NULL,NULL,NULL,'6400','data',100,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(56,32,0,0,'Target velocity','DINT','DINT',32,0,'rw',127,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(57,33,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(58,33,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(59,33,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(60,34,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'06','data',6,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(61,34,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(62,34,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(63,34,3,3,'SubIndex 003','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(64,34,4,4,'SubIndex 004','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(65,34,5,5,'SubIndex 005','UDINT','UDINT',32,144,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(66,34,6,6,'SubIndex 006','UDINT','UDINT',32,176,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(67,35,0,0,'Target torque','INT','INT',16,0,'rw',127,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(68,36,0,0,'Torque demand value','INT','INT',16,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(69,37,0,0,'Torque slope','UDINT','UDINT',32,0,'rw',127,NULL,'R',NULL,'E8030000','data',1000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(70,38,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'03','data',3,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(71,38,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(72,38,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(73,38,3,3,'SubIndex 003','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(74,39,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'06','data',6,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(75,39,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(76,39,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(77,39,3,3,'SubIndex 003','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(78,39,4,4,'SubIndex 004','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(79,39,5,5,'SubIndex 005','UDINT','UDINT',32,144,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(80,39,6,6,'SubIndex 006','UDINT','UDINT',32,176,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(81,40,0,0,'Commutation angle','UINT','UINT',16,0,'rw',127,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(82,41,0,0,'Device type','UDINT','UDINT',32,0,'ro',7,'m',NULL,NULL,'92010200','data',131474,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(83,42,0,0,'Error register','USINT','USINT',8,0,'ro',7,'m',NULL,NULL,'00','data',0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(84,43,0,0,'Device name','STRING(8)','STRING',64,0,'ro',7,'o',NULL,NULL,'ECX-A202','string',NULL,NULL,'ECX-A202',NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(85,44,0,0,'Hardware version','STRING(4)','STRING',32,0,'ro',7,'o',NULL,NULL,'1.00','string',NULL,NULL,'1.00',NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(86,45,0,0,'Software version','STRING(4)','STRING',32,0,'ro',7,'o',NULL,NULL,'1.02','string',NULL,NULL,'1.02',NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(87,46,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'04','data',4,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(88,46,1,1,'Vendor ID','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,'5C0E0000','data',3676,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(89,46,2,2,'Product Code','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,'02A20000','data',41474,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(90,46,3,3,'Revision Number','UDINT','UDINT',32,80,'ro',7,NULL,NULL,NULL,'02000100','data',65538,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(91,46,4,4,'Serial Number','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,'00000000','data',0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(92,47,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(93,47,1,1,'Local error reaction','UDINT','UDINT',32,16,'rw',63,NULL,NULL,NULL,'01000000','data',1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(94,47,2,2,'Sync error counter limit','UINT','UINT',16,48,'rw',63,NULL,NULL,NULL,'0400','data',4,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(95,48,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'04','data',4,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(96,48,1,1,'SubIndex 001','USINT','USINT',8,16,'ro',7,NULL,NULL,NULL,'01','data',1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(97,48,2,2,'SubIndex 002','USINT','USINT',8,24,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(98,48,3,3,'SubIndex 003','USINT','USINT',8,32,'ro',7,NULL,NULL,NULL,'03','data',3,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(99,48,4,4,'SubIndex 004','USINT','USINT',8,40,'ro',7,NULL,NULL,NULL,'04','data',4,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(100,49,0,0,'SubIndex 000','USINT','USINT',8,0,'rw',63,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(101,49,1,1,'SubIndex 001','UINT','UINT',16,16,'rw',63,NULL,NULL,NULL,'0017','data',5888,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(102,49,2,2,'SubIndex 002','UINT','UINT',16,32,'rw',63,NULL,NULL,NULL,'4017','data',5952,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(103,50,0,0,'SubIndex 000','USINT','USINT',8,0,'rw',63,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(104,50,1,1,'SubIndex 001','UINT','UINT',16,16,'rw',63,NULL,NULL,NULL,'001B','data',6912,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(105,50,2,2,'SubIndex 002','UINT','UINT',16,32,'rw',63,NULL,NULL,NULL,'401B','data',6976,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(106,51,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'20','data',32,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(107,51,1,1,'Synchronization type','UINT','UINT',16,16,'rw',63,NULL,NULL,NULL,'0200','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(108,51,2,2,'Cycle time','UDINT','UDINT',32,32,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(109,51,3,4,'Synchronization types supported','UINT','UINT',16,96,'ro',7,NULL,NULL,NULL,'0600','data',6,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(110,51,4,5,'Minimum cycle time','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,'48E80100','data',125000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(111,51,5,6,'Calc and copy time','UDINT','UDINT',32,144,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(112,51,6,8,'Get cycle time','UINT','UINT',16,208,'rw',63,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(113,51,7,9,'Delay time','UDINT','UDINT',32,224,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(114,51,8,10,'Sync0 cycle time','UDINT','UDINT',32,256,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(115,51,9,11,'SM event missed counter','UINT','UINT',16,288,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(116,51,10,12,'Cycle exceeded counter','UINT','UINT',16,304,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(117,51,11,13,'Shift too short counter','UINT','UINT',16,320,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(118,51,12,32,'Sync error','BOOL','BOOL',1,480,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(119,52,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'20','data',32,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(120,52,1,1,'Synchronization type','UINT','UINT',16,16,'rw',63,NULL,NULL,NULL,'0200','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(121,52,2,2,'Cycle time','UDINT','UDINT',32,32,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(122,52,3,4,'Synchronization types supported','UINT','UINT',16,96,'ro',7,NULL,NULL,NULL,'0600','data',6,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(123,52,4,5,'Minimum cycle time','UDINT','UDINT',32,112,'ro',7,NULL,NULL,NULL,'48E80100','data',125000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(124,52,5,6,'Calc and copy time','UDINT','UDINT',32,144,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(125,52,6,8,'Get cycle time','UINT','UINT',16,208,'rw',63,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(126,52,7,9,'Delay time','UDINT','UDINT',32,224,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(127,52,8,10,'Sync0 cycle time','UDINT','UDINT',32,256,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(128,52,9,11,'SM event missed counter','UINT','UINT',16,288,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(129,52,10,12,'Cycle exceeded counter','UINT','UINT',16,304,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(130,52,11,13,'Shift too short counter','UINT','UINT',16,320,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(131,52,12,32,'Sync error','BOOL','BOOL',1,480,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(132,53,0,0,'DC link circuit voltage','UDINT','UDINT',32,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(133,54,0,0,'Digital inputs','UDINT','UDINT',32,0,'ro',135,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(134,55,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(135,55,1,1,'Index distance','UINT','UINT',16,16,'ro',7,NULL,NULL,NULL,'0008','data',2048,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(136,55,2,2,'Maximum number of modules','UINT','UINT',16,32,'ro',7,NULL,NULL,NULL,'0200','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(137,56,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(138,56,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,'92010000','data',402,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(139,56,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,'92010000','data',402,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(140,57,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(141,57,1,1,'SubIndex 001','UDINT','UDINT',32,16,'rw',63,NULL,NULL,NULL,'00080100','data',67584,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(142,57,2,2,'SubIndex 002','UDINT','UDINT',32,48,'rw',63,NULL,NULL,NULL,'00080100','data',67584,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(143,58,0,0,'SubIndex 000','USINT','USINT',8,0,'ro',7,NULL,NULL,NULL,'02','data',2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(144,58,1,1,'SubIndex 001','UDINT','UDINT',32,16,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "object_entries" VALUES(145,58,2,2,'SubIndex 002','UDINT','UDINT',32,48,'ro',7,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE objects (
	id INTEGER NOT NULL,
	content_hash BLOB NOT NULL,
	default_string TEXT,
	min_data TEXT,
	max_data TEXT,
	default_data TEXT,
	min_value INTEGER,
	max_value INTEGER,
	default_value INTEGER,
	info_sub_items TEXT,
	display_names TEXT,
	unit INTEGER,
	scaling TEXT,
	object_index INTEGER,
	depend_on_slot INTEGER,
	depend_on_slot_group INTEGER,
	overwritten_by_module INTEGER,
	name TEXT,
	names TEXT,
	comments TEXT,
	type TEXT,
	bit_size INTEGER,
	has_flags INTEGER,
	access TEXT,
	read_restrictions TEXT,
	write_restrictions TEXT,
	category TEXT,
	pdo_mapping TEXT,
	safety_mapping TEXT,
	attribute INTEGER,
	backup INTEGER,
	setting INTEGER,
	transition TEXT,
	sdo_access TEXT,
	flags_spelling TEXT,
	properties TEXT,
	xml TEXT,
	spelling TEXT,
	object_code INTEGER NOT NULL,
	CONSTRAINT pk_objects PRIMARY KEY (id),
	CONSTRAINT uq_objects_content_hash UNIQUE (content_hash)
)
 STRICT;
INSERT INTO "objects" VALUES(1,X'4C787853E7CC495D8584485B9E2C4CB7',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"04","name":"SubIndex 000"}]',NULL,NULL,NULL,5888,1,NULL,NULL,'CSP outputs mapping',NULL,NULL,'DT1700',144,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(2,X'BC39A9333CF363B196EF412693F3363A',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"07","name":"SubIndex 000"}]',NULL,NULL,NULL,6912,1,NULL,NULL,'CSP inputs mapping',NULL,NULL,'DT1B00',240,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(3,X'0114C8D58A6DEDEC4DA9298661AAD760',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24639,1,NULL,NULL,'Error code',NULL,NULL,'UINT',16,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(4,X'E683052F6F8FC06745EBB80FC645CC8D',NULL,NULL,NULL,'0000',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24640,1,NULL,NULL,'Controlword',NULL,NULL,'UINT',16,1,'rw',NULL,NULL,'m','R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(5,X'3122302D59E9C87E68E9E1881ED184A9',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24641,1,NULL,NULL,'Statusword',NULL,NULL,'UINT',16,1,'ro',NULL,NULL,'m','T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(6,X'FF07B7D9CEB13E4BB8A7E346778A2543',NULL,NULL,NULL,'0200',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24666,1,NULL,NULL,'Quick stop option code',NULL,NULL,'INT',16,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(7,X'98E474959DB97A62B11A852D97E60B6A',NULL,NULL,NULL,'0200',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24670,1,NULL,NULL,'Fault reaction option code',NULL,NULL,'INT',16,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(8,X'F0F1CCA7A1DDFA940498BC9BEC96D904',NULL,NULL,NULL,'00',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24672,1,NULL,NULL,'Modes of operation',NULL,NULL,'SINT',8,1,'rw',NULL,NULL,'m','R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(9,X'7FB8673565458EE2A98FE613F5D1317E',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24673,1,NULL,NULL,'Modes of operation display',NULL,NULL,'SINT',8,1,'ro',NULL,NULL,'m','T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(10,X'26FCA4D664C653840DD0BCD293709956',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24674,1,NULL,NULL,'Position demand value',NULL,NULL,'DINT',32,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(11,X'CB3A8269B472A7797C7C185FA6C101C6',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24676,1,NULL,NULL,'Position actual value',NULL,NULL,'DINT',32,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(12,X'420A1DCC782F68D26360BAFFB17D421E',NULL,NULL,NULL,'A00F0000',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24677,1,NULL,NULL,'Following error window',NULL,NULL,'UDINT',32,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(13,X'8C91E0034B6B60DF2109F803F9BA8C8E',NULL,NULL,NULL,'0A000000',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24679,1,NULL,NULL,'Position window',NULL,NULL,'UDINT',32,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(14,X'CFCEDA6670CBBD8FBB297E98A1D5E000',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24684,1,NULL,NULL,'Velocity actual value',NULL,NULL,'DINT',32,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(15,X'87102510A134EE1472EEB2E16707A63F',NULL,NULL,NULL,'B80B',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24690,1,NULL,NULL,'Max torque',NULL,NULL,'UINT',16,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(16,X'329BF1CF160B0CD38B37E4B957C4540F',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24695,1,NULL,NULL,'Torque actual value',NULL,NULL,'INT',16,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(17,X'6596D22042C93718A5634C1045D3DD51',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24698,1,NULL,NULL,'Target position',NULL,NULL,'DINT',32,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(18,X'29743A4906CC9D836E2EBC41C11C3405',NULL,NULL,NULL,'70170000',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24704,1,NULL,NULL,'Max motor speed',NULL,NULL,'UDINT',32,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(19,X'E515DBBDA777A0816E6AFDBD37150FE0',NULL,NULL,NULL,'A0860100',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24709,1,NULL,NULL,'Quick stop deceleration',NULL,NULL,'UDINT',32,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(20,X'56088D3C8E746DDC542F2ED7E89D6BD8',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"00001000","name":"Encoder increments"},{"default_data":"01000000","name":"Motor revolutions"}]',NULL,NULL,NULL,24719,1,NULL,NULL,'Position encoder resolution',NULL,NULL,'DT608F',80,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(21,X'1044089CB7E7C337AC5DAEB5C31EEB74',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24752,1,NULL,NULL,'Position offset',NULL,NULL,'DINT',32,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(22,X'BFD6AF3BA42F8AE9C679558D8F8561AB',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24753,1,NULL,NULL,'Velocity offset',NULL,NULL,'DINT',32,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(23,X'55E9E05C3B605E026EC59D783E908AB9',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24754,1,NULL,NULL,'Torque offset',NULL,NULL,'INT',16,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(24,X'751CDB31C114C0261C48D23054AFD2D1',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"01","name":"Interpolation time period value"},{"default_data":"FD","name":"Interpolation time index"}]',NULL,NULL,NULL,24770,1,NULL,NULL,'Interpolation time period',NULL,NULL,'DT60C2',32,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(25,X'6872DBD3DC7ADF795572E6B9E1850405',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24820,1,NULL,NULL,'Following error actual value',NULL,NULL,'DINT',32,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(26,X'4C381CDB2B75FB94C14918B5CD20A89E',NULL,NULL,NULL,'0300',NULL,NULL,NULL,NULL,NULL,NULL,NULL,25602,1,NULL,NULL,'Motor type',NULL,NULL,'UINT',16,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(27,X'FF6DD1CC82478E5DE6ABEFE55A4E1192',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,25858,1,NULL,NULL,'Supported drive modes',NULL,NULL,'UDINT',32,1,'ro',NULL,NULL,'m',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(28,X'8DF5F579CAE06EBB97485CB3187A59B2',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"03","name":"SubIndex 000"}]',NULL,NULL,NULL,5889,1,NULL,NULL,'CSV outputs mapping',NULL,NULL,'DT1701',112,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(29,X'3AEDCE5807F10FC9F7098AD8C25D7CF3',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"06","name":"SubIndex 000"}]',NULL,NULL,NULL,6913,1,NULL,NULL,'CSV inputs mapping',NULL,NULL,'DT1B01',208,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(30,X'730782A71EC1C082D7A537EE246EB296',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24683,1,NULL,NULL,'Velocity demand value',NULL,NULL,'DINT',32,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(31,X'D9324AE441CBFCE4DE6D9B8372E0FE8D',NULL,NULL,NULL,'6400',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24685,1,NULL,NULL,'Velocity window',NULL,NULL,'UINT',16,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(32,X'DA04B766F46B8742934BCF5940528203',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24831,1,NULL,NULL,'Target velocity',NULL,NULL,'DINT',32,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(33,X'F34FA53B0FAC9CCA95795896E2AA2F57',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"}]',NULL,NULL,NULL,5890,1,NULL,NULL,'CST outputs mapping',NULL,NULL,'DT1702',80,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(34,X'B480F340451BF0678AE994719F3DED70',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"06","name":"SubIndex 000"}]',NULL,NULL,NULL,6914,1,NULL,NULL,'CST inputs mapping',NULL,NULL,'DT1B02',208,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(35,X'963E4C523ED79F9A5D8D764834B72E5C',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24689,1,NULL,NULL,'Target torque',NULL,NULL,'INT',16,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(36,X'686C1FA1697ADD9FDFC69B529F96F13A',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24692,1,NULL,NULL,'Torque demand value',NULL,NULL,'INT',16,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(37,X'614B0F0FCB8D35C051BA21661B8622D6',NULL,NULL,NULL,'E8030000',NULL,NULL,NULL,NULL,NULL,NULL,NULL,24711,1,NULL,NULL,'Torque slope',NULL,NULL,'UDINT',32,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(38,X'3F4ECC85CB485CFFF366A7EAC3CF01E6',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"03","name":"SubIndex 000"}]',NULL,NULL,NULL,5891,1,NULL,NULL,'CSTCA outputs mapping',NULL,NULL,'DT1703',112,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(39,X'2FD467F7C70DFD77D9A83A8363CC02F2',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"06","name":"SubIndex 000"}]',NULL,NULL,NULL,6915,1,NULL,NULL,'CSTCA inputs mapping',NULL,NULL,'DT1B03',208,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',9);
INSERT INTO "objects" VALUES(40,X'EBDF2A3E3C17063FDD24AB3160937A12',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24810,1,NULL,NULL,'Commutation angle',NULL,NULL,'UINT',16,1,'rw',NULL,NULL,NULL,'R',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',7);
INSERT INTO "objects" VALUES(41,X'3BF6DCFA2C858F038D483BB98585B3CF',NULL,NULL,NULL,'92010200',NULL,NULL,NULL,NULL,NULL,NULL,NULL,4096,NULL,NULL,NULL,'Device type',NULL,NULL,'UDINT',32,1,'ro',NULL,NULL,'m',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,7);
INSERT INTO "objects" VALUES(42,X'79CD8229AC6B04DA7766FA0F4552F7C8',NULL,NULL,NULL,'00',NULL,NULL,NULL,NULL,NULL,NULL,NULL,4097,NULL,NULL,NULL,'Error register',NULL,NULL,'USINT',8,1,'ro',NULL,NULL,'m',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,7);
INSERT INTO "objects" VALUES(43,X'A782ED7D01BFB0979AD2BF1ADF12B26B','ECX-A202',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,4104,NULL,NULL,NULL,'Device name',NULL,NULL,'STRING(8)',64,1,'ro',NULL,NULL,'o',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,7);
INSERT INTO "objects" VALUES(44,X'E1CAC3138637E7457AC4AC2E8ACE91F7','1.00',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,4105,NULL,NULL,NULL,'Hardware version',NULL,NULL,'STRING(4)',32,1,'ro',NULL,NULL,'o',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,7);
INSERT INTO "objects" VALUES(45,X'A4CA8C879EE89679635AAEC8DF3F5729','1.02',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,4106,NULL,NULL,NULL,'Software version',NULL,NULL,'STRING(4)',32,1,'ro',NULL,NULL,'o',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,7);
INSERT INTO "objects" VALUES(46,X'855E9628075BDBD4E67799135CE89347',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"04","name":"SubIndex 000"},{"default_data":"5C0E0000","name":"Vendor ID"},{"default_data":"02A20000","name":"Product Code"},{"default_data":"02000100","name":"Revision Number"},{"default_data":"00000000","name":"Serial Number"}]',NULL,NULL,NULL,4120,NULL,NULL,NULL,'Identity object',NULL,NULL,'DT1018',144,1,'ro',NULL,NULL,'m',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,9);
INSERT INTO "objects" VALUES(47,X'8210F616903D58171D3FF4FED1F57372',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"01000000","name":"Local error reaction"},{"default_data":"0400","name":"Sync error counter limit"}]',NULL,NULL,NULL,4337,NULL,NULL,NULL,'Error settings',NULL,NULL,'DT10F1',64,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,9);
INSERT INTO "objects" VALUES(48,X'7504F71DE4103116C5F65930E7E58BE0',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"04","name":"SubIndex 000"},{"default_data":"01","name":"SubIndex 001"},{"default_data":"02","name":"SubIndex 002"},{"default_data":"03","name":"SubIndex 003"},{"default_data":"04","name":"SubIndex 004"}]',NULL,NULL,NULL,7168,NULL,NULL,NULL,'Sync manager type',NULL,NULL,'DT1C00',48,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,8);
INSERT INTO "objects" VALUES(49,X'57587F6C82CDE95C1E48F1E8C8CB052C',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"0017","name":"SubIndex 001"},{"default_data":"4017","name":"SubIndex 002"}]',NULL,NULL,NULL,7186,NULL,NULL,NULL,'RxPDO assign',NULL,NULL,'DT1C12',48,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,8);
INSERT INTO "objects" VALUES(50,X'95B7F8B05F387FDB52CE1AD1FBC069C6',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"001B","name":"SubIndex 001"},{"default_data":"401B","name":"SubIndex 002"}]',NULL,NULL,NULL,7187,NULL,NULL,NULL,'TxPDO assign',NULL,NULL,'DT1C13',48,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,8);
INSERT INTO "objects" VALUES(51,X'CA3542AD6A2CCB592C5C1484AA35A65C',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"20","name":"SubIndex 000"},{"default_data":"0200","name":"Synchronization type"},{"default_data":"0600","name":"Synchronization types supported"},{"default_data":"48E80100","name":"Minimum cycle time"}]',NULL,NULL,NULL,7218,NULL,NULL,NULL,'SM output parameter',NULL,NULL,'DT1C32',488,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,9);
INSERT INTO "objects" VALUES(52,X'E1B6816AC0AC93AFF9FA330DA2C32C7D',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"20","name":"SubIndex 000"},{"default_data":"0200","name":"Synchronization type"},{"default_data":"0600","name":"Synchronization types supported"},{"default_data":"48E80100","name":"Minimum cycle time"}]',NULL,NULL,NULL,7219,NULL,NULL,NULL,'SM input parameter',NULL,NULL,'DT1C32',488,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,9);
INSERT INTO "objects" VALUES(53,X'9C2A5D2CCCE5C052DF379892C4B6C9B1',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24697,NULL,NULL,NULL,'DC link circuit voltage',NULL,NULL,'UDINT',32,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,7);
INSERT INTO "objects" VALUES(54,X'36A843A3917CF87C3DDD8320A21FA53C',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,24829,NULL,NULL,NULL,'Digital inputs',NULL,NULL,'UDINT',32,1,'ro',NULL,NULL,NULL,'T',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,7);
INSERT INTO "objects" VALUES(55,X'7DAF1E0858147C7F1FC8692473BBB19E',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"0008","name":"Index distance"},{"default_data":"0200","name":"Maximum number of modules"}]',NULL,NULL,NULL,61440,NULL,NULL,NULL,'Modular device profile',NULL,NULL,'DTF000',48,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,9);
INSERT INTO "objects" VALUES(56,X'F4243A92093CB661B240B6153ACBC695',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"92010000","name":"SubIndex 001"},{"default_data":"92010000","name":"SubIndex 002"}]',NULL,NULL,NULL,61456,NULL,NULL,NULL,'Module profile list',NULL,NULL,'DTF010',80,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,8);
INSERT INTO "objects" VALUES(57,X'F5C021518FE6B13BC6FA6008B3C263EE',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"},{"default_data":"00080100","name":"SubIndex 001"},{"default_data":"00080100","name":"SubIndex 002"}]',NULL,NULL,NULL,61488,NULL,NULL,NULL,'Configured module ident list',NULL,NULL,'DTF030',80,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,8);
INSERT INTO "objects" VALUES(58,X'95A3F2BF730D5DC5BFB3AD230938C27D',NULL,NULL,NULL,NULL,NULL,NULL,NULL,'[{"default_data":"02","name":"SubIndex 000"}]',NULL,NULL,NULL,61520,NULL,NULL,NULL,'Detected module ident list',NULL,NULL,'DTF050',80,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,8);
CREATE TABLE pdo_entries (
	id INTEGER NOT NULL,
	pdo_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	entry_index INTEGER,
	depend_on_slot INTEGER,
	depend_on_slot_group INTEGER,
	subindex INTEGER,
	bit_length INTEGER,
	name TEXT,
	names TEXT,
	comments TEXT,
	data_type TEXT,
	dscale TEXT,
	swap_data TEXT,
	fixed INTEGER,
	safety_conn_number INTEGER,
	ads_info TEXT,
	spelling TEXT,
	is_padding INTEGER, image_bit_offset INTEGER,
	CONSTRAINT pk_pdo_entries PRIMARY KEY (id),
	CONSTRAINT fk_pdo_entries_pdo_id FOREIGN KEY(pdo_id) REFERENCES pdos (id)
)
 STRICT;
INSERT INTO "pdo_entries" VALUES(1,1,0,28672,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,0);
INSERT INTO "pdo_entries" VALUES(2,2,0,28688,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,1);
INSERT INTO "pdo_entries" VALUES(3,3,0,28704,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,2);
INSERT INTO "pdo_entries" VALUES(4,4,0,28720,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,3);
INSERT INTO "pdo_entries" VALUES(5,5,0,28736,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,4);
INSERT INTO "pdo_entries" VALUES(6,6,0,28752,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,5);
INSERT INTO "pdo_entries" VALUES(7,7,0,28768,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,6);
INSERT INTO "pdo_entries" VALUES(8,8,0,28784,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,7);
INSERT INTO "pdo_entries" VALUES(9,9,0,24576,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,0);
INSERT INTO "pdo_entries" VALUES(10,10,0,24592,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,1);
INSERT INTO "pdo_entries" VALUES(11,11,0,24608,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,2);
INSERT INTO "pdo_entries" VALUES(12,12,0,24624,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,3);
INSERT INTO "pdo_entries" VALUES(13,13,0,24640,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,4);
INSERT INTO "pdo_entries" VALUES(14,14,0,24656,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,5);
INSERT INTO "pdo_entries" VALUES(15,15,0,24672,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,6);
INSERT INTO "pdo_entries" VALUES(16,16,0,24688,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,7);
INSERT INTO "pdo_entries" VALUES(17,17,0,28672,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,0);
INSERT INTO "pdo_entries" VALUES(18,18,0,28688,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,1);
INSERT INTO "pdo_entries" VALUES(19,19,0,28704,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,2);
INSERT INTO "pdo_entries" VALUES(20,20,0,28720,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,3);
INSERT INTO "pdo_entries" VALUES(21,21,0,28736,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,4);
INSERT INTO "pdo_entries" VALUES(22,22,0,28752,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,5);
INSERT INTO "pdo_entries" VALUES(23,23,0,28768,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,6);
INSERT INTO "pdo_entries" VALUES(24,24,0,28784,NULL,NULL,1,1,'Output','[{"text":"Output","lcid":1033},{"text":"Ausgang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,7);
INSERT INTO "pdo_entries" VALUES(25,25,0,24576,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,0);
INSERT INTO "pdo_entries" VALUES(26,26,0,24592,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,1);
INSERT INTO "pdo_entries" VALUES(27,27,0,24608,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,2);
INSERT INTO "pdo_entries" VALUES(28,28,0,24624,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,3);
INSERT INTO "pdo_entries" VALUES(29,29,0,24640,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,4);
INSERT INTO "pdo_entries" VALUES(30,30,0,24656,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,5);
INSERT INTO "pdo_entries" VALUES(31,31,0,24672,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,6);
INSERT INTO "pdo_entries" VALUES(32,32,0,24688,NULL,NULL,1,1,'Input','[{"text":"Input","lcid":1033},{"text":"Eingang","lcid":1031}]',NULL,'BOOL',NULL,NULL,NULL,NULL,NULL,NULL,0,7);
INSERT INTO "pdo_entries" VALUES(33,33,0,24640,1,NULL,0,16,'Controlword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(34,33,1,24698,1,NULL,0,32,'Target position',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(35,33,2,24753,1,NULL,0,32,'Velocity offset',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(36,33,3,24754,1,NULL,0,16,'Torque offset',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(37,34,0,24641,1,NULL,0,16,'Statusword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(38,34,1,24673,1,NULL,0,8,'Modes of operation display',NULL,NULL,'SINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(39,34,2,0,NULL,NULL,NULL,8,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"entry_index":"0"}',1,NULL);
INSERT INTO "pdo_entries" VALUES(40,34,3,24676,1,NULL,0,32,'Position actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(41,34,4,24820,1,NULL,0,32,'Following error actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(42,34,5,24684,1,NULL,0,32,'Velocity actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(43,34,6,24695,1,NULL,0,16,'Torque actual value',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(44,35,0,24640,1,NULL,0,16,'Controlword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(45,35,1,24831,1,NULL,0,32,'Target velocity',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(46,35,2,24754,1,NULL,0,16,'Torque offset',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(47,36,0,24641,1,NULL,0,16,'Statusword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(48,36,1,24673,1,NULL,0,8,'Modes of operation display',NULL,NULL,'SINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(49,36,2,0,NULL,NULL,NULL,8,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"entry_index":"0"}',1,NULL);
INSERT INTO "pdo_entries" VALUES(50,36,3,24676,1,NULL,0,32,'Position actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(51,36,4,24684,1,NULL,0,32,'Velocity actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(52,36,5,24695,1,NULL,0,16,'Torque actual value',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(53,37,0,24640,1,NULL,0,16,'Controlword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(54,37,1,24689,1,NULL,0,16,'Target torque',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(55,38,0,24641,1,NULL,0,16,'Statusword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(56,38,1,24673,1,NULL,0,8,'Modes of operation display',NULL,NULL,'SINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(57,38,2,0,NULL,NULL,NULL,8,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"entry_index":"0"}',1,NULL);
INSERT INTO "pdo_entries" VALUES(58,38,3,24676,1,NULL,0,32,'Position actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(59,38,4,24684,1,NULL,0,32,'Velocity actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(60,38,5,24695,1,NULL,0,16,'Torque actual value',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(61,39,0,24640,1,NULL,0,16,'Controlword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(62,39,1,24689,1,NULL,0,16,'Target torque',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(63,39,2,24810,1,NULL,0,16,'Commutation angle',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(64,40,0,24641,1,NULL,0,16,'Statusword',NULL,NULL,'UINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(65,40,1,24673,1,NULL,0,8,'Modes of operation display',NULL,NULL,'SINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(66,40,2,0,NULL,NULL,NULL,8,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"entry_index":"0"}',1,NULL);
INSERT INTO "pdo_entries" VALUES(67,40,3,24676,1,NULL,0,32,'Position actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(68,40,4,24684,1,NULL,0,32,'Velocity actual value',NULL,NULL,'DINT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
INSERT INTO "pdo_entries" VALUES(69,40,5,24695,1,NULL,0,16,'Torque actual value',NULL,NULL,'INT',NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',0,NULL);
CREATE TABLE pdo_exclusions (
	id INTEGER NOT NULL,
	pdo_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	pdo_index INTEGER,
	depend_on_slot INTEGER,
	depend_on_slot_group INTEGER,
	spelling TEXT,
	CONSTRAINT pk_pdo_exclusions PRIMARY KEY (id),
	CONSTRAINT fk_pdo_exclusions_pdo_id FOREIGN KEY(pdo_id) REFERENCES pdos (id)
)
 STRICT;
CREATE TABLE pdos (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	direction TEXT NOT NULL,
	pdo_index INTEGER,
	depend_on_slot INTEGER,
	depend_on_slot_group INTEGER,
	name TEXT,
	names TEXT,
	excluded_sms TEXT,
	sm INTEGER,
	fixed INTEGER,
	mandatory INTEGER,
	"virtual" INTEGER,
	su INTEGER,
	pdo_order INTEGER,
	os_fac INTEGER,
	os_min INTEGER,
	os_max INTEGER,
	os_index_inc INTEGER,
	overwritten_by_module INTEGER,
	sra_parameter INTEGER,
	safety_pdo_type TEXT,
	safety_conn_number INTEGER,
	ref TEXT,
	channel TEXT,
	spelling TEXT,
	bit_size INTEGER,
	entry_count INTEGER, image_sm INTEGER,
	CONSTRAINT pk_pdos PRIMARY KEY (id),
	CONSTRAINT ck_pdos_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_pdos_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_pdos_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "pdos" VALUES(1,1,NULL,0,'RxPdo',5632,NULL,NULL,'DO Channel 1','[{"text":"DO Channel 1","lcid":1033},{"text":"DO Kanal 1","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(2,1,NULL,1,'RxPdo',5633,NULL,NULL,'DO Channel 2','[{"text":"DO Channel 2","lcid":1033},{"text":"DO Kanal 2","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(3,1,NULL,2,'RxPdo',5634,NULL,NULL,'DO Channel 3','[{"text":"DO Channel 3","lcid":1033},{"text":"DO Kanal 3","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(4,1,NULL,3,'RxPdo',5635,NULL,NULL,'DO Channel 4','[{"text":"DO Channel 4","lcid":1033},{"text":"DO Kanal 4","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(5,1,NULL,4,'RxPdo',5636,NULL,NULL,'DO Channel 5','[{"text":"DO Channel 5","lcid":1033},{"text":"DO Kanal 5","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(6,1,NULL,5,'RxPdo',5637,NULL,NULL,'DO Channel 6','[{"text":"DO Channel 6","lcid":1033},{"text":"DO Kanal 6","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(7,1,NULL,6,'RxPdo',5638,NULL,NULL,'DO Channel 7','[{"text":"DO Channel 7","lcid":1033},{"text":"DO Kanal 7","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(8,1,NULL,7,'RxPdo',5639,NULL,NULL,'DO Channel 8','[{"text":"DO Channel 8","lcid":1033},{"text":"DO Kanal 8","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(9,1,NULL,0,'TxPdo',6656,NULL,NULL,'DI Channel 1','[{"text":"DI Channel 1","lcid":1033},{"text":"DI Kanal 1","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(10,1,NULL,1,'TxPdo',6657,NULL,NULL,'DI Channel 2','[{"text":"DI Channel 2","lcid":1033},{"text":"DI Kanal 2","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(11,1,NULL,2,'TxPdo',6658,NULL,NULL,'DI Channel 3','[{"text":"DI Channel 3","lcid":1033},{"text":"DI Kanal 3","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(12,1,NULL,3,'TxPdo',6659,NULL,NULL,'DI Channel 4','[{"text":"DI Channel 4","lcid":1033},{"text":"DI Kanal 4","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(13,1,NULL,4,'TxPdo',6660,NULL,NULL,'DI Channel 5','[{"text":"DI Channel 5","lcid":1033},{"text":"DI Kanal 5","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(14,1,NULL,5,'TxPdo',6661,NULL,NULL,'DI Channel 6','[{"text":"DI Channel 6","lcid":1033},{"text":"DI Kanal 6","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(15,1,NULL,6,'TxPdo',6662,NULL,NULL,'DI Channel 7','[{"text":"DI Channel 7","lcid":1033},{"text":"DI Kanal 7","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(16,1,NULL,7,'TxPdo',6663,NULL,NULL,'DI Channel 8','[{"text":"DI Channel 8","lcid":1033},{"text":"DI Kanal 8","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(17,2,NULL,0,'RxPdo',5632,NULL,NULL,'DO Channel 1','[{"text":"DO Channel 1","lcid":1033},{"text":"DO Kanal 1","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(18,2,NULL,1,'RxPdo',5633,NULL,NULL,'DO Channel 2','[{"text":"DO Channel 2","lcid":1033},{"text":"DO Kanal 2","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(19,2,NULL,2,'RxPdo',5634,NULL,NULL,'DO Channel 3','[{"text":"DO Channel 3","lcid":1033},{"text":"DO Kanal 3","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(20,2,NULL,3,'RxPdo',5635,NULL,NULL,'DO Channel 4','[{"text":"DO Channel 4","lcid":1033},{"text":"DO Kanal 4","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(21,2,NULL,4,'RxPdo',5636,NULL,NULL,'DO Channel 5','[{"text":"DO Channel 5","lcid":1033},{"text":"DO Kanal 5","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(22,2,NULL,5,'RxPdo',5637,NULL,NULL,'DO Channel 6','[{"text":"DO Channel 6","lcid":1033},{"text":"DO Kanal 6","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(23,2,NULL,6,'RxPdo',5638,NULL,NULL,'DO Channel 7','[{"text":"DO Channel 7","lcid":1033},{"text":"DO Kanal 7","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(24,2,NULL,7,'RxPdo',5639,NULL,NULL,'DO Channel 8','[{"text":"DO Channel 8","lcid":1033},{"text":"DO Kanal 8","lcid":1031}]',NULL,0,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,0);
INSERT INTO "pdos" VALUES(25,2,NULL,0,'TxPdo',6656,NULL,NULL,'DI Channel 1','[{"text":"DI Channel 1","lcid":1033},{"text":"DI Kanal 1","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(26,2,NULL,1,'TxPdo',6657,NULL,NULL,'DI Channel 2','[{"text":"DI Channel 2","lcid":1033},{"text":"DI Kanal 2","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(27,2,NULL,2,'TxPdo',6658,NULL,NULL,'DI Channel 3','[{"text":"DI Channel 3","lcid":1033},{"text":"DI Kanal 3","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(28,2,NULL,3,'TxPdo',6659,NULL,NULL,'DI Channel 4','[{"text":"DI Channel 4","lcid":1033},{"text":"DI Kanal 4","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(29,2,NULL,4,'TxPdo',6660,NULL,NULL,'DI Channel 5','[{"text":"DI Channel 5","lcid":1033},{"text":"DI Kanal 5","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(30,2,NULL,5,'TxPdo',6661,NULL,NULL,'DI Channel 6','[{"text":"DI Channel 6","lcid":1033},{"text":"DI Kanal 6","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(31,2,NULL,6,'TxPdo',6662,NULL,NULL,'DI Channel 7','[{"text":"DI Channel 7","lcid":1033},{"text":"DI Kanal 7","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(32,2,NULL,7,'TxPdo',6663,NULL,NULL,'DI Channel 8','[{"text":"DI Channel 8","lcid":1033},{"text":"DI Kanal 8","lcid":1031}]',NULL,1,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,1,1,1);
INSERT INTO "pdos" VALUES(33,NULL,1,0,'RxPdo',5888,1,NULL,'CSP outputs',NULL,NULL,2,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',96,4,NULL);
INSERT INTO "pdos" VALUES(34,NULL,1,0,'TxPdo',6912,1,NULL,'CSP inputs',NULL,NULL,3,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',144,7,NULL);
INSERT INTO "pdos" VALUES(35,NULL,2,0,'RxPdo',5889,1,NULL,'CSV outputs',NULL,NULL,2,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',64,3,NULL);
INSERT INTO "pdos" VALUES(36,NULL,2,0,'TxPdo',6913,1,NULL,'CSV inputs',NULL,NULL,3,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',112,6,NULL);
INSERT INTO "pdos" VALUES(37,NULL,3,0,'RxPdo',5890,1,NULL,'CST outputs',NULL,NULL,2,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',32,2,NULL);
INSERT INTO "pdos" VALUES(38,NULL,3,0,'TxPdo',6914,1,NULL,'CST inputs',NULL,NULL,3,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',112,6,NULL);
INSERT INTO "pdos" VALUES(39,NULL,4,0,'RxPdo',5891,1,NULL,'CSTCA outputs',NULL,NULL,2,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',48,3,NULL);
INSERT INTO "pdos" VALUES(40,NULL,4,0,'TxPdo',6915,1,NULL,'CSTCA inputs',NULL,NULL,3,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"depend_on_slot":"true"}',112,6,NULL);
CREATE TABLE profile_channels (
	id INTEGER NOT NULL,
	profile_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	profile_no INTEGER,
	add_info INTEGER,
	sub_add_info INTEGER,
	display_names TEXT,
	overwritten_by_module INTEGER,
	channel_group INTEGER,
	spelling TEXT,
	CONSTRAINT pk_profile_channels PRIMARY KEY (id),
	CONSTRAINT fk_profile_channels_profile_id FOREIGN KEY(profile_id) REFERENCES profiles (id)
)
 STRICT;
INSERT INTO "profile_channels" VALUES(1,1,0,5001,100,NULL,'[{"text":"Digital inputs","lcid":1033},{"text":"Digitale Eingänge","lcid":1031}]',NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(2,1,1,5001,200,NULL,'[{"text":"Digital outputs","lcid":1033},{"text":"Digitale Ausgänge","lcid":1031}]',NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(3,2,0,5001,100,NULL,'[{"text":"Digital inputs","lcid":1033},{"text":"Digitale Eingänge","lcid":1031}]',NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(4,2,1,5001,200,NULL,'[{"text":"Digital outputs","lcid":1033},{"text":"Digitale Ausgänge","lcid":1031}]',NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(5,3,0,402,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(6,4,0,402,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(7,5,0,402,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(8,6,0,402,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(9,7,0,402,NULL,NULL,'[{"text":"Axis A","lcid":1033}]',NULL,NULL,NULL);
INSERT INTO "profile_channels" VALUES(10,7,1,402,NULL,NULL,'[{"text":"Axis B","lcid":1033}]',NULL,NULL,NULL);
CREATE TABLE profiles (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	dictionary_id INTEGER,
	diagnostics_id INTEGER,
	channel INTEGER,
	profile_no INTEGER,
	add_info INTEGER,
	sub_add_info INTEGER,
	channel_count INTEGER,
	dictionary_file TEXT,
	diag_files TEXT,
	spelling TEXT,
	CONSTRAINT pk_profiles PRIMARY KEY (id),
	CONSTRAINT ck_profiles_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_profiles_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_profiles_diagnostics_id FOREIGN KEY(diagnostics_id) REFERENCES diagnostics (id),
	CONSTRAINT fk_profiles_dictionary_id FOREIGN KEY(dictionary_id) REFERENCES dictionaries (id),
	CONSTRAINT fk_profiles_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "profiles" VALUES(1,1,NULL,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profiles" VALUES(2,2,NULL,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profiles" VALUES(3,NULL,1,0,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profiles" VALUES(4,NULL,2,0,2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profiles" VALUES(5,NULL,3,0,3,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profiles" VALUES(6,NULL,4,0,4,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "profiles" VALUES(7,3,NULL,0,5,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE slot_module_classes (
	id INTEGER NOT NULL,
	slot_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	module_class TEXT,
	class_vendor_id INTEGER,
	name TEXT,
	names TEXT,
	image_symbol TEXT,
	image_file TEXT,
	image_sha256 TEXT,
	spelling TEXT,
	CONSTRAINT pk_slot_module_classes PRIMARY KEY (id),
	CONSTRAINT fk_slot_module_classes_slot_id FOREIGN KEY(slot_id) REFERENCES slots (id)
)
 STRICT;
CREATE TABLE slot_modules (
	id INTEGER NOT NULL,
	slot_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	module_ident INTEGER,
	is_default INTEGER,
	spelling TEXT,
	CONSTRAINT pk_slot_modules PRIMARY KEY (id),
	CONSTRAINT fk_slot_modules_slot_id FOREIGN KEY(slot_id) REFERENCES slots (id)
)
 STRICT;
INSERT INTO "slot_modules" VALUES(1,1,0,67584,1,NULL);
INSERT INTO "slot_modules" VALUES(2,1,1,67840,0,NULL);
INSERT INTO "slot_modules" VALUES(3,1,2,68096,0,NULL);
INSERT INTO "slot_modules" VALUES(4,1,3,68352,0,NULL);
INSERT INTO "slot_modules" VALUES(5,2,0,67584,1,NULL);
INSERT INTO "slot_modules" VALUES(6,2,1,67840,0,NULL);
INSERT INTO "slot_modules" VALUES(7,2,2,68096,0,NULL);
INSERT INTO "slot_modules" VALUES(8,2,3,68352,0,NULL);
CREATE TABLE slots (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	name TEXT,
	names TEXT,
	slot_group INTEGER,
	min_instances INTEGER,
	max_instances INTEGER,
	slot_pdo_increment INTEGER,
	slot_group_pdo_increment INTEGER,
	slot_index_increment INTEGER,
	slot_group_index_increment INTEGER,
	tree_view TEXT,
	default_ident INTEGER,
	fallback_ident INTEGER,
	image_symbol TEXT,
	image_file TEXT,
	image_sha256 TEXT,
	spelling TEXT,
	CONSTRAINT pk_slots PRIMARY KEY (id),
	CONSTRAINT ck_slots_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_slots_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_slots_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "slots" VALUES(1,3,NULL,0,'Axis A','[{"text":"Axis A","lcid":1033}]',NULL,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "slots" VALUES(2,3,NULL,1,'Axis B','[{"text":"Axis B","lcid":1033}]',NULL,1,1,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE source_groups (
	id INTEGER NOT NULL,
	source_id INTEGER NOT NULL,
	group_id INTEGER NOT NULL,
	section INTEGER NOT NULL,
	position INTEGER NOT NULL,
	CONSTRAINT pk_source_groups PRIMARY KEY (id),
	CONSTRAINT fk_source_groups_group_id FOREIGN KEY(group_id) REFERENCES groups (id),
	CONSTRAINT fk_source_groups_source_id FOREIGN KEY(source_id) REFERENCES sources (id)
)
 STRICT;
INSERT INTO "source_groups" VALUES(1,1,1,0,0);
INSERT INTO "source_groups" VALUES(2,1,2,0,1);
INSERT INTO "source_groups" VALUES(3,2,3,0,0);
CREATE TABLE source_references (
	id INTEGER NOT NULL,
	source_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	kind TEXT NOT NULL,
	reference TEXT NOT NULL,
	found_location TEXT,
	sha256 TEXT,
	CONSTRAINT pk_source_references PRIMARY KEY (id),
	CONSTRAINT fk_source_references_source_id FOREIGN KEY(source_id) REFERENCES sources (id)
)
 STRICT;
CREATE TABLE source_vendors (
	id INTEGER NOT NULL,
	source_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	schema_version TEXT,
	info_references TEXT,
	shared_pdos TEXT,
	has_vendor INTEGER NOT NULL,
	vendor_id INTEGER,
	name TEXT,
	names TEXT,
	comments TEXT,
	urls TEXT,
	description_url TEXT,
	file_version INTEGER,
	unique_name TEXT,
	image_symbol TEXT,
	image_file TEXT,
	image_sha256 TEXT,
	vendor_specific TEXT,
	spelling TEXT,
	CONSTRAINT pk_source_vendors PRIMARY KEY (id),
	CONSTRAINT fk_source_vendors_source_id FOREIGN KEY(source_id) REFERENCES sources (id)
)
 STRICT;
INSERT INTO "source_vendors" VALUES(1,1,0,'1.17',NULL,NULL,1,3676,'esicatalog examples','[{"text":"esicatalog examples","lcid":1033}]',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "source_vendors" VALUES(2,2,0,'1.17',NULL,NULL,1,3676,'esicatalog examples','[{"text":"esicatalog examples","lcid":1033}]',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE sources (
	id INTEGER NOT NULL,
	location TEXT NOT NULL,
	member TEXT NOT NULL,
	archive_id INTEGER,
	status TEXT NOT NULL,
	message TEXT,
	sha256 TEXT,
	byte_count INTEGER,
	reader_version TEXT NOT NULL,
	root TEXT,
	encoding TEXT,
	device_count INTEGER NOT NULL,
	module_count INTEGER NOT NULL,
	dictionary_id INTEGER,
	diagnostics_id INTEGER, is_whole INTEGER,
	CONSTRAINT pk_sources PRIMARY KEY (id),
	CONSTRAINT fk_sources_archive_id FOREIGN KEY(archive_id) REFERENCES archives (id),
	CONSTRAINT fk_sources_diagnostics_id FOREIGN KEY(diagnostics_id) REFERENCES diagnostics (id),
	CONSTRAINT fk_sources_dictionary_id FOREIGN KEY(dictionary_id) REFERENCES dictionaries (id),
	CONSTRAINT uq_sources_location UNIQUE (location)
)
 STRICT;
INSERT INTO "sources" VALUES(1,'io_terminal_8di_8do.xml','io_terminal_8di_8do.xml',NULL,'stored',NULL,'e6e0c9f2abb457cad50688d19f0ce791b55db1be4c2fd72dce86556545e5e68e',25294,'0.4.10','EtherCATInfo','UTF-8',2,0,NULL,NULL,1);
INSERT INTO "sources" VALUES(2,'two_axis_modular_drive.xml','two_axis_modular_drive.xml',NULL,'stored',NULL,'7e2214e9ee6e24a71ed445d1f459608b99980d835cddf1839007ebad6eb399b3',122045,'0.4.10','EtherCATInfo','UTF-8',1,4,NULL,NULL,1);
ANALYZE "sqlite_master";
INSERT INTO "sqlite_stat1" VALUES('vendor_names','ix_vendor_names_vendor_id','1 1');
INSERT INTO "sqlite_stat1" VALUES('device_names','ix_device_names_module_id','10 2');
INSERT INTO "sqlite_stat1" VALUES('device_names','ix_device_names_device_id','10 3');
INSERT INTO "sqlite_stat1" VALUES('hidden_revisions','ix_hidden_revisions_module_id','1 1');
INSERT INTO "sqlite_stat1" VALUES('hidden_revisions','ix_hidden_revisions_device_id','1 1');
INSERT INTO "sqlite_stat1" VALUES('devices','ix_devices_listed','3 3 2 1 1 1 1');
INSERT INTO "sqlite_stat1" VALUES('devices','sqlite_autoindex_devices_2','3 3 2 1 1');
INSERT INTO "sqlite_stat1" VALUES('devices','sqlite_autoindex_devices_1','3 1');
INSERT INTO "sqlite_stat1" VALUES('device_sources','ix_device_sources_source_id','3 2');
INSERT INTO "sqlite_stat1" VALUES('device_sources','ix_device_sources_device_id','3 1');
CREATE TABLE sub_items (
	id INTEGER NOT NULL,
	data_type_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	subindex INTEGER,
	name TEXT,
	display_names TEXT,
	type TEXT,
	comments TEXT,
	bit_size INTEGER,
	bit_offset INTEGER,
	default_string TEXT,
	default_data TEXT,
	min_value INTEGER,
	max_value INTEGER,
	default_value INTEGER,
	has_flags INTEGER,
	access TEXT,
	read_restrictions TEXT,
	write_restrictions TEXT,
	category TEXT,
	pdo_mapping TEXT,
	safety_mapping TEXT,
	attribute INTEGER,
	backup INTEGER,
	setting INTEGER,
	transition TEXT,
	sdo_access TEXT,
	flags_spelling TEXT,
	properties TEXT,
	xml TEXT,
	spelling TEXT,
	CONSTRAINT pk_sub_items PRIMARY KEY (id),
	CONSTRAINT fk_sub_items_data_type_id FOREIGN KEY(data_type_id) REFERENCES data_types (id)
)
 STRICT;
INSERT INTO "sub_items" VALUES(1,7,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(2,7,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(3,7,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(4,7,3,3,'SubIndex 003',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(5,7,4,4,'SubIndex 004',NULL,'UDINT',NULL,32,112,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(6,8,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(7,8,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(8,8,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(9,8,3,3,'SubIndex 003',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(10,8,4,4,'SubIndex 004',NULL,'UDINT',NULL,32,112,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(11,8,5,5,'SubIndex 005',NULL,'UDINT',NULL,32,144,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(12,8,6,6,'SubIndex 006',NULL,'UDINT',NULL,32,176,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(13,8,7,7,'SubIndex 007',NULL,'UDINT',NULL,32,208,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(14,9,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(15,9,1,1,'Encoder increments',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(16,9,2,2,'Motor revolutions',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(17,10,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(18,10,1,1,'Interpolation time period value',NULL,'USINT',NULL,8,16,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(19,10,2,2,'Interpolation time index',NULL,'SINT',NULL,8,24,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(20,11,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(21,11,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(22,11,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(23,11,3,3,'SubIndex 003',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(24,12,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(25,12,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(26,12,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(27,12,3,3,'SubIndex 003',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(28,12,4,4,'SubIndex 004',NULL,'UDINT',NULL,32,112,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(29,12,5,5,'SubIndex 005',NULL,'UDINT',NULL,32,144,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(30,12,6,6,'SubIndex 006',NULL,'UDINT',NULL,32,176,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(31,13,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(32,13,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(33,13,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(34,14,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(35,14,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(36,14,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(37,14,3,3,'SubIndex 003',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(38,14,4,4,'SubIndex 004',NULL,'UDINT',NULL,32,112,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(39,14,5,5,'SubIndex 005',NULL,'UDINT',NULL,32,144,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(40,14,6,6,'SubIndex 006',NULL,'UDINT',NULL,32,176,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(41,15,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(42,15,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(43,15,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(44,15,3,3,'SubIndex 003',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(45,16,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(46,16,1,1,'SubIndex 001',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(47,16,2,2,'SubIndex 002',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(48,16,3,3,'SubIndex 003',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(49,16,4,4,'SubIndex 004',NULL,'UDINT',NULL,32,112,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(50,16,5,5,'SubIndex 005',NULL,'UDINT',NULL,32,144,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(51,16,6,6,'SubIndex 006',NULL,'UDINT',NULL,32,176,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(52,20,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(53,20,1,1,'Vendor ID',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(54,20,2,2,'Product Code',NULL,'UDINT',NULL,32,48,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(55,20,3,3,'Revision Number',NULL,'UDINT',NULL,32,80,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(56,20,4,4,'Serial Number',NULL,'UDINT',NULL,32,112,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(57,22,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(58,22,1,NULL,'Elements',NULL,'DT1C00ARR',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(59,24,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(60,24,1,NULL,'Elements',NULL,'DT1C12ARR',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(61,26,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(62,26,1,NULL,'Elements',NULL,'DT1C13ARR',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(63,27,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(64,27,1,1,'Synchronization type',NULL,'UINT',NULL,16,16,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(65,27,2,2,'Cycle time',NULL,'UDINT',NULL,32,32,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(66,27,3,4,'Synchronization types supported',NULL,'UINT',NULL,16,96,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(67,27,4,5,'Minimum cycle time',NULL,'UDINT',NULL,32,112,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(68,27,5,6,'Calc and copy time',NULL,'UDINT',NULL,32,144,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(69,27,6,8,'Get cycle time',NULL,'UINT',NULL,16,208,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(70,27,7,9,'Delay time',NULL,'UDINT',NULL,32,224,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(71,27,8,10,'Sync0 cycle time',NULL,'UDINT',NULL,32,256,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(72,27,9,11,'SM event missed counter',NULL,'UINT',NULL,16,288,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(73,27,10,12,'Cycle exceeded counter',NULL,'UINT',NULL,16,304,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(74,27,11,13,'Shift too short counter',NULL,'UINT',NULL,16,320,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(75,27,12,32,'Sync error',NULL,'BOOL',NULL,1,480,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(76,28,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(77,28,1,1,'Local error reaction',NULL,'UDINT',NULL,32,16,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(78,28,2,2,'Sync error counter limit',NULL,'UINT',NULL,16,48,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(79,29,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(80,29,1,1,'Index distance',NULL,'UINT',NULL,16,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(81,29,2,2,'Maximum number of modules',NULL,'UINT',NULL,16,32,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(82,31,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(83,31,1,NULL,'Elements',NULL,'DTF010ARR',NULL,64,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(84,33,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(85,33,1,NULL,'Elements',NULL,'DTF030ARR',NULL,64,16,NULL,NULL,NULL,NULL,NULL,1,'rw',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(86,35,0,0,'SubIndex 000',NULL,'USINT',NULL,8,0,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "sub_items" VALUES(87,35,1,NULL,'Elements',NULL,'DTF050ARR',NULL,64,16,NULL,NULL,NULL,NULL,NULL,1,'ro',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE sync_managers (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	usage TEXT,
	min_size INTEGER,
	max_size INTEGER,
	default_size INTEGER,
	start_address INTEGER,
	control_byte INTEGER,
	enable INTEGER,
	one_byte_mode INTEGER,
	"virtual" INTEGER,
	watchdog INTEGER,
	op_only INTEGER,
	fixed_assignment INTEGER,
	spelling TEXT,
	buffer_mode TEXT,
	transfer_direction TEXT,
	ecat_interrupt INTEGER,
	pdi_interrupt INTEGER,
	watchdog_trigger INTEGER,
	CONSTRAINT pk_sync_managers PRIMARY KEY (id),
	CONSTRAINT ck_sync_managers_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_sync_managers_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_sync_managers_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "sync_managers" VALUES(1,1,NULL,0,'Outputs',NULL,NULL,1,3840,68,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x44"}','buffered','output',0,0,1);
INSERT INTO "sync_managers" VALUES(2,1,NULL,1,'Inputs',NULL,NULL,1,4096,0,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x00"}','buffered','input',0,0,0);
INSERT INTO "sync_managers" VALUES(3,2,NULL,0,'Outputs',NULL,NULL,1,3840,68,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x44"}','buffered','output',0,0,1);
INSERT INTO "sync_managers" VALUES(4,2,NULL,1,'Inputs',NULL,NULL,1,4096,0,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x00"}','buffered','input',0,0,0);
INSERT INTO "sync_managers" VALUES(5,3,NULL,0,'MBoxOut',64,512,256,4096,38,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x26"}','mailbox','output',0,1,0);
INSERT INTO "sync_managers" VALUES(6,3,NULL,1,'MBoxIn',64,512,256,4608,34,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x22"}','mailbox','input',0,1,0);
INSERT INTO "sync_managers" VALUES(7,3,NULL,2,'Outputs',0,64,24,5120,100,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x64"}','buffered','output',0,1,1);
INSERT INTO "sync_managers" VALUES(8,3,NULL,3,'Inputs',0,64,36,6144,32,1,NULL,NULL,NULL,NULL,NULL,'{"control_byte":"#x20"}','buffered','input',0,1,0);
CREATE TABLE sync_units (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	position INTEGER NOT NULL,
	name TEXT,
	separate_su INTEGER,
	separate_frame INTEGER,
	depend_on_input_state INTEGER,
	frame_repeat_support INTEGER,
	spelling TEXT,
	CONSTRAINT pk_sync_units PRIMARY KEY (id),
	CONSTRAINT ck_sync_units_one_owner CHECK ((device_id IS NULL) <> (module_id IS NULL)),
	CONSTRAINT fk_sync_units_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_sync_units_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
CREATE TABLE type_set_data_types (
	type_set_id INTEGER NOT NULL,
	position INTEGER NOT NULL,
	data_type_id INTEGER NOT NULL,
	CONSTRAINT pk_type_set_data_types PRIMARY KEY (type_set_id, position),
	CONSTRAINT fk_type_set_data_types_data_type_id FOREIGN KEY(data_type_id) REFERENCES data_types (id),
	CONSTRAINT fk_type_set_data_types_type_set_id FOREIGN KEY(type_set_id) REFERENCES type_sets (id)
)
 WITHOUT ROWID,
 STRICT;
INSERT INTO "type_set_data_types" VALUES(1,0,1);
INSERT INTO "type_set_data_types" VALUES(2,0,1);
INSERT INTO "type_set_data_types" VALUES(3,0,1);
INSERT INTO "type_set_data_types" VALUES(4,0,1);
INSERT INTO "type_set_data_types" VALUES(1,1,2);
INSERT INTO "type_set_data_types" VALUES(2,1,2);
INSERT INTO "type_set_data_types" VALUES(3,1,2);
INSERT INTO "type_set_data_types" VALUES(4,1,2);
INSERT INTO "type_set_data_types" VALUES(5,1,2);
INSERT INTO "type_set_data_types" VALUES(1,2,3);
INSERT INTO "type_set_data_types" VALUES(2,2,3);
INSERT INTO "type_set_data_types" VALUES(3,2,3);
INSERT INTO "type_set_data_types" VALUES(4,2,3);
INSERT INTO "type_set_data_types" VALUES(1,3,4);
INSERT INTO "type_set_data_types" VALUES(2,3,4);
INSERT INTO "type_set_data_types" VALUES(3,3,4);
INSERT INTO "type_set_data_types" VALUES(4,3,4);
INSERT INTO "type_set_data_types" VALUES(5,2,4);
INSERT INTO "type_set_data_types" VALUES(1,4,5);
INSERT INTO "type_set_data_types" VALUES(2,4,5);
INSERT INTO "type_set_data_types" VALUES(3,4,5);
INSERT INTO "type_set_data_types" VALUES(4,4,5);
INSERT INTO "type_set_data_types" VALUES(1,5,6);
INSERT INTO "type_set_data_types" VALUES(2,5,6);
INSERT INTO "type_set_data_types" VALUES(3,5,6);
INSERT INTO "type_set_data_types" VALUES(4,5,6);
INSERT INTO "type_set_data_types" VALUES(5,3,6);
INSERT INTO "type_set_data_types" VALUES(1,6,7);
INSERT INTO "type_set_data_types" VALUES(1,7,8);
INSERT INTO "type_set_data_types" VALUES(1,8,9);
INSERT INTO "type_set_data_types" VALUES(2,8,9);
INSERT INTO "type_set_data_types" VALUES(3,8,9);
INSERT INTO "type_set_data_types" VALUES(4,8,9);
INSERT INTO "type_set_data_types" VALUES(1,9,10);
INSERT INTO "type_set_data_types" VALUES(2,9,10);
INSERT INTO "type_set_data_types" VALUES(3,9,10);
INSERT INTO "type_set_data_types" VALUES(4,9,10);
INSERT INTO "type_set_data_types" VALUES(2,6,11);
INSERT INTO "type_set_data_types" VALUES(2,7,12);
INSERT INTO "type_set_data_types" VALUES(3,6,13);
INSERT INTO "type_set_data_types" VALUES(3,7,14);
INSERT INTO "type_set_data_types" VALUES(4,6,15);
INSERT INTO "type_set_data_types" VALUES(4,7,16);
INSERT INTO "type_set_data_types" VALUES(5,0,17);
INSERT INTO "type_set_data_types" VALUES(5,4,18);
INSERT INTO "type_set_data_types" VALUES(5,5,19);
INSERT INTO "type_set_data_types" VALUES(5,6,20);
INSERT INTO "type_set_data_types" VALUES(5,7,21);
INSERT INTO "type_set_data_types" VALUES(5,8,22);
INSERT INTO "type_set_data_types" VALUES(5,9,23);
INSERT INTO "type_set_data_types" VALUES(5,10,24);
INSERT INTO "type_set_data_types" VALUES(5,11,25);
INSERT INTO "type_set_data_types" VALUES(5,12,26);
INSERT INTO "type_set_data_types" VALUES(5,13,27);
INSERT INTO "type_set_data_types" VALUES(5,14,28);
INSERT INTO "type_set_data_types" VALUES(5,15,29);
INSERT INTO "type_set_data_types" VALUES(5,16,30);
INSERT INTO "type_set_data_types" VALUES(5,17,31);
INSERT INTO "type_set_data_types" VALUES(5,18,32);
INSERT INTO "type_set_data_types" VALUES(5,19,33);
INSERT INTO "type_set_data_types" VALUES(5,20,34);
INSERT INTO "type_set_data_types" VALUES(5,21,35);
CREATE TABLE type_sets (
	id INTEGER NOT NULL,
	content_hash BLOB NOT NULL,
	CONSTRAINT pk_type_sets PRIMARY KEY (id),
	CONSTRAINT uq_type_sets_content_hash UNIQUE (content_hash)
)
 STRICT;
INSERT INTO "type_sets" VALUES(1,X'D958BB4301D4E05C3826746E5F6A08B0');
INSERT INTO "type_sets" VALUES(2,X'7559978AF210CD326FAAB3FA658776ED');
INSERT INTO "type_sets" VALUES(3,X'A12784A3F874B061E7330E2D20FFF589');
INSERT INTO "type_sets" VALUES(4,X'CFC9A36A9B088427086CF0E7B6C8A407');
INSERT INTO "type_sets" VALUES(5,X'118898355058BE9D49E058782906352E');
CREATE TABLE unmapped (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	source_id INTEGER,
	position INTEGER NOT NULL,
	path TEXT NOT NULL,
	value TEXT NOT NULL,
	CONSTRAINT pk_unmapped PRIMARY KEY (id),
	CONSTRAINT fk_unmapped_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_unmapped_module_id FOREIGN KEY(module_id) REFERENCES modules (id),
	CONSTRAINT fk_unmapped_source_id FOREIGN KEY(source_id) REFERENCES sources (id)
)
 STRICT;
CREATE TABLE vendor_extensions (
	id INTEGER NOT NULL,
	device_id INTEGER,
	module_id INTEGER,
	owner_table TEXT NOT NULL,
	owner_position INTEGER NOT NULL,
	field TEXT NOT NULL,
	xml TEXT NOT NULL,
	CONSTRAINT pk_vendor_extensions PRIMARY KEY (id),
	CONSTRAINT fk_vendor_extensions_device_id FOREIGN KEY(device_id) REFERENCES devices (id),
	CONSTRAINT fk_vendor_extensions_module_id FOREIGN KEY(module_id) REFERENCES modules (id)
)
 STRICT;
INSERT INTO "vendor_extensions" VALUES(1,3,NULL,'',0,'info_vendor_specific','<VendorSpecific><ErrorHandling><AutoRestoreAfterWcOk>1</AutoRestoreAfterWcOk></ErrorHandling></VendorSpecific>');
CREATE TABLE vendor_names (
	id INTEGER NOT NULL,
	vendor_id INTEGER NOT NULL,
	lcid INTEGER,
	name TEXT NOT NULL,
	document_count INTEGER NOT NULL,
	CONSTRAINT pk_vendor_names PRIMARY KEY (id),
	CONSTRAINT fk_vendor_names_vendor_id FOREIGN KEY(vendor_id) REFERENCES vendors (vendor_id)
)
 STRICT;
INSERT INTO "vendor_names" VALUES(1,3676,1033,'esicatalog examples',2);
CREATE TABLE vendors (
	vendor_id INTEGER NOT NULL,
	name TEXT,
	image_sha256 TEXT,
	CONSTRAINT pk_vendors PRIMARY KEY (vendor_id)
)
 STRICT;
INSERT INTO "vendors" VALUES(3676,'esicatalog examples',NULL);
CREATE INDEX ix_sub_items_data_type_id ON sub_items (data_type_id);
CREATE INDEX ix_vendor_names_vendor_id ON vendor_names (vendor_id);
CREATE INDEX ix_device_names_device_id ON device_names (device_id);
CREATE INDEX ix_hidden_revisions_device_id ON hidden_revisions (device_id);
CREATE INDEX ix_pdos_device_id ON pdos (device_id);
CREATE INDEX ix_device_sources_device_id ON device_sources (device_id);
CREATE INDEX ix_pdo_entries_pdo_id ON pdo_entries (pdo_id);
CREATE INDEX ix_object_entries_subindex ON object_entries (object_id, subindex);
CREATE INDEX ix_groups_vendor_id ON groups (vendor_id);
CREATE INDEX ix_objects_object_index ON objects (object_index);
CREATE INDEX ix_devices_listed ON devices (vendor_id, product_code, revision_no, type, variant, hidden);
CREATE INDEX ix_diag_messages_diagnostics_id ON diag_messages (diagnostics_id);
CREATE INDEX ix_dictionaries_type_set_id ON dictionaries (type_set_id);
CREATE INDEX ix_enum_values_data_type_id ON enum_values (data_type_id);
CREATE INDEX ix_modules_vendor_id ON modules (vendor_id);
CREATE INDEX ix_modules_ident ON modules (vendor_id, module_ident);
CREATE INDEX ix_type_set_data_types_data_type_id ON type_set_data_types (data_type_id);
CREATE INDEX ix_dc_modes_device_id ON dc_modes (device_id);
CREATE INDEX ix_dc_modes_module_id ON dc_modes (module_id);
CREATE INDEX ix_device_facts_image_signature ON device_facts (image_signature);
CREATE INDEX ix_device_modules_module_id ON device_modules (module_id);
CREATE INDEX ix_device_names_module_id ON device_names (module_id);
CREATE INDEX ix_dictionary_objects_object_id ON dictionary_objects (object_id);
CREATE INDEX ix_drive_modes_kind_mode ON drive_modes (kind, mode, verdict);
CREATE INDEX ix_eeproms_device_id ON eeproms (device_id);
CREATE INDEX ix_eeproms_module_id ON eeproms (module_id);
CREATE INDEX ix_fmmus_module_id ON fmmus (module_id);
CREATE INDEX ix_fmmus_device_id ON fmmus (device_id);
CREATE INDEX ix_hidden_revisions_module_id ON hidden_revisions (module_id);
CREATE INDEX ix_initcmds_module_id ON initcmds (module_id);
CREATE INDEX ix_initcmds_device_id ON initcmds (device_id);
CREATE INDEX ix_mailboxes_module_id ON mailboxes (module_id);
CREATE INDEX ix_mailboxes_device_id ON mailboxes (device_id);
CREATE INDEX ix_pdos_module_id ON pdos (module_id);
CREATE INDEX ix_profiles_device_id ON profiles (device_id);
CREATE INDEX ix_profiles_diagnostics_id ON profiles (diagnostics_id);
CREATE INDEX ix_profiles_module_id ON profiles (module_id);
CREATE INDEX ix_profiles_dictionary ON profiles (dictionary_id, device_id, module_id);
CREATE INDEX ix_slots_module_id ON slots (module_id);
CREATE INDEX ix_slots_device_id ON slots (device_id);
CREATE INDEX ix_sources_sha256 ON sources (sha256);
CREATE INDEX ix_sources_archive_id ON sources (archive_id);
CREATE INDEX ix_sources_dictionary_id ON sources (dictionary_id);
CREATE INDEX ix_sources_diagnostics_id ON sources (diagnostics_id);
CREATE INDEX ix_sources_status ON sources (status);
CREATE INDEX ix_sync_managers_module_id ON sync_managers (module_id);
CREATE INDEX ix_sync_managers_device_id ON sync_managers (device_id);
CREATE INDEX ix_sync_units_device_id ON sync_units (device_id);
CREATE INDEX ix_sync_units_module_id ON sync_units (module_id);
CREATE INDEX ix_vendor_extensions_device_id ON vendor_extensions (device_id);
CREATE INDEX ix_vendor_extensions_module_id ON vendor_extensions (module_id);
CREATE INDEX ix_device_sources_source_id ON device_sources (source_id);
CREATE INDEX ix_findings_source_id ON findings (source_id);
CREATE INDEX ix_findings_rule ON findings (rule);
CREATE INDEX ix_module_sources_module_id ON module_sources (module_id);
CREATE INDEX ix_module_sources_source_id ON module_sources (source_id);
CREATE INDEX ix_pdo_entries_mapping ON pdo_entries (entry_index, subindex, bit_length, pdo_id);
CREATE INDEX ix_pdo_exclusions_pdo_id ON pdo_exclusions (pdo_id);
CREATE INDEX ix_profile_channels_profile_id ON profile_channels (profile_id);
CREATE INDEX ix_slot_module_classes_slot_id ON slot_module_classes (slot_id);
CREATE INDEX ix_slot_modules_slot_id ON slot_modules (slot_id);
CREATE INDEX ix_source_groups_group_id ON source_groups (group_id);
CREATE INDEX ix_source_groups_source_id ON source_groups (source_id);
CREATE INDEX ix_source_references_source_id ON source_references (source_id);
CREATE INDEX ix_source_vendors_source_id ON source_vendors (source_id);
CREATE INDEX ix_unmapped_module_id ON unmapped (module_id);
CREATE INDEX ix_unmapped_device_id ON unmapped (device_id);
CREATE INDEX ix_unmapped_source_id ON unmapped (source_id);
COMMIT;
