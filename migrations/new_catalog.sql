-- Written by docs/generate.py
CREATE TABLE alembic_version (
	version_num VARCHAR(32) NOT NULL,
	CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num)
);

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

CREATE INDEX ix_groups_vendor_id ON groups (vendor_id);

CREATE TABLE images (
	sha256 TEXT NOT NULL,
	data BLOB,
	malformed TEXT,
	CONSTRAINT pk_images PRIMARY KEY (sha256)
)
 STRICT;

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

CREATE INDEX ix_objects_object_index ON objects (object_index);

CREATE TABLE type_sets (
	id INTEGER NOT NULL,
	content_hash BLOB NOT NULL,
	CONSTRAINT pk_type_sets PRIMARY KEY (id),
	CONSTRAINT uq_type_sets_content_hash UNIQUE (content_hash)
)
 STRICT;

CREATE TABLE vendors (
	vendor_id INTEGER NOT NULL,
	name TEXT,
	image_sha256 TEXT,
	CONSTRAINT pk_vendors PRIMARY KEY (vendor_id)
)
 STRICT;

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

CREATE INDEX ix_diag_messages_diagnostics_id ON diag_messages (diagnostics_id);

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

CREATE INDEX ix_dictionaries_type_set_id ON dictionaries (type_set_id);

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

CREATE INDEX ix_enum_values_data_type_id ON enum_values (data_type_id);

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

CREATE INDEX ix_modules_ident ON modules (vendor_id, module_ident);

CREATE INDEX ix_modules_vendor_id ON modules (vendor_id);

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

CREATE INDEX ix_sub_items_data_type_id ON sub_items (data_type_id);

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

CREATE INDEX ix_type_set_data_types_data_type_id ON type_set_data_types (data_type_id);

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

CREATE INDEX ix_vendor_names_vendor_id ON vendor_names (vendor_id);

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

CREATE INDEX ix_dc_modes_device_id ON dc_modes (device_id);

CREATE INDEX ix_dc_modes_module_id ON dc_modes (module_id);

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

CREATE INDEX ix_device_modules_module_id ON device_modules (module_id);

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

CREATE INDEX ix_device_names_device_id ON device_names (device_id);

CREATE INDEX ix_device_names_module_id ON device_names (module_id);

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

CREATE INDEX ix_dictionary_objects_object_id ON dictionary_objects (object_id);

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

CREATE INDEX ix_eeproms_device_id ON eeproms (device_id);

CREATE INDEX ix_eeproms_module_id ON eeproms (module_id);

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

CREATE INDEX ix_fmmus_device_id ON fmmus (device_id);

CREATE INDEX ix_fmmus_module_id ON fmmus (module_id);

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

CREATE INDEX ix_hidden_revisions_device_id ON hidden_revisions (device_id);

CREATE INDEX ix_hidden_revisions_module_id ON hidden_revisions (module_id);

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

CREATE INDEX ix_initcmds_device_id ON initcmds (device_id);

CREATE INDEX ix_initcmds_module_id ON initcmds (module_id);

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

CREATE INDEX ix_mailboxes_device_id ON mailboxes (device_id);

CREATE INDEX ix_mailboxes_module_id ON mailboxes (module_id);

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

CREATE INDEX ix_pdos_device_id ON pdos (device_id);

CREATE INDEX ix_pdos_module_id ON pdos (module_id);

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

CREATE INDEX ix_profiles_device_id ON profiles (device_id);

CREATE INDEX ix_profiles_diagnostics_id ON profiles (diagnostics_id);

CREATE INDEX ix_profiles_module_id ON profiles (module_id);

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

CREATE INDEX ix_slots_device_id ON slots (device_id);

CREATE INDEX ix_slots_module_id ON slots (module_id);

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

CREATE INDEX ix_sources_archive_id ON sources (archive_id);

CREATE INDEX ix_sources_diagnostics_id ON sources (diagnostics_id);

CREATE INDEX ix_sources_dictionary_id ON sources (dictionary_id);

CREATE INDEX ix_sources_sha256 ON sources (sha256);

CREATE INDEX ix_sources_status ON sources (status);

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

CREATE INDEX ix_sync_managers_device_id ON sync_managers (device_id);

CREATE INDEX ix_sync_managers_module_id ON sync_managers (module_id);

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

CREATE INDEX ix_sync_units_device_id ON sync_units (device_id);

CREATE INDEX ix_sync_units_module_id ON sync_units (module_id);

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

CREATE INDEX ix_vendor_extensions_device_id ON vendor_extensions (device_id);

CREATE INDEX ix_vendor_extensions_module_id ON vendor_extensions (module_id);

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

CREATE INDEX ix_device_sources_device_id ON device_sources (device_id);

CREATE INDEX ix_device_sources_source_id ON device_sources (source_id);

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

CREATE INDEX ix_findings_rule ON findings (rule);

CREATE INDEX ix_findings_source_id ON findings (source_id);

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

CREATE INDEX ix_module_sources_module_id ON module_sources (module_id);

CREATE INDEX ix_module_sources_source_id ON module_sources (source_id);

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

CREATE INDEX ix_pdo_entries_pdo_id ON pdo_entries (pdo_id);

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

CREATE INDEX ix_pdo_exclusions_pdo_id ON pdo_exclusions (pdo_id);

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

CREATE INDEX ix_profile_channels_profile_id ON profile_channels (profile_id);

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

CREATE INDEX ix_slot_module_classes_slot_id ON slot_module_classes (slot_id);

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

CREATE INDEX ix_slot_modules_slot_id ON slot_modules (slot_id);

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

CREATE INDEX ix_source_groups_group_id ON source_groups (group_id);

CREATE INDEX ix_source_groups_source_id ON source_groups (source_id);

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

CREATE INDEX ix_source_references_source_id ON source_references (source_id);

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

CREATE INDEX ix_source_vendors_source_id ON source_vendors (source_id);

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

CREATE INDEX ix_unmapped_device_id ON unmapped (device_id);

CREATE INDEX ix_unmapped_module_id ON unmapped (module_id);

CREATE INDEX ix_unmapped_source_id ON unmapped (source_id);

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

CREATE INDEX ix_device_facts_image_signature ON device_facts (image_signature);

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

CREATE INDEX ix_devices_listed ON devices (vendor_id, product_code, revision_no, type, variant, hidden);

CREATE INDEX ix_drive_modes_kind_mode ON drive_modes (kind, mode, verdict);

CREATE INDEX ix_object_entries_subindex ON object_entries (object_id, subindex);

CREATE INDEX ix_pdo_entries_mapping ON pdo_entries (entry_index, subindex, bit_length, pdo_id);

CREATE INDEX ix_profiles_dictionary ON profiles (dictionary_id, device_id, module_id);

CREATE VIEW device_overview AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, d.group_type, d.physics, d.e_bus_current_ma, d.invisible, CAST((SELECT min(coalesce(p.profile_no, c.profile_no)) FROM profiles p LEFT JOIN profile_channels c ON c.profile_id = p.id WHERE p.device_id = d.id) AS BIGINT) AS profile_no, b.coe, b.eoe, b.foe, b.soe, b.aoe, b.voe, b.coe_complete_access, b.coe_sdo_info, CAST((SELECT count(*) FROM dc_modes x WHERE x.device_id = d.id) AS BIGINT) AS dc_modes, CAST(CASE WHEN f.supports_sync0 THEN 1 ELSE 0 END AS BIGINT) AS sync0, CAST(CASE WHEN f.supports_sync1 THEN 1 ELSE 0 END AS BIGINT) AS sync1, CAST((SELECT count(*) FROM pdos x WHERE x.device_id = d.id AND x.direction = 'RxPdo') AS BIGINT) AS rx_pdos, CAST((SELECT count(*) FROM pdos x WHERE x.device_id = d.id AND x.direction = 'TxPdo') AS BIGINT) AS tx_pdos, CAST((SELECT count(*) FROM slots x WHERE x.device_id = d.id) AS BIGINT) AS slots, CAST((SELECT count(*) FROM device_modules x WHERE x.device_id = d.id) AS BIGINT) AS modules, CAST((SELECT count(DISTINCT x.source_id) FROM device_sources x WHERE x.device_id = d.id) AS BIGINT) AS sources FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN device_facts f ON f.device_id = d.id LEFT JOIN mailboxes b ON b.device_id = d.id;

CREATE VIEW device_objects AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, p.position AS profile, CASE WHEN o.object_index IS NOT NULL THEN printf('0x%04x', o.object_index) END AS object_index_hex, o.default_string, o.min_data, o.max_data, o.default_data, o.min_value, o.max_value, o.default_value, o.info_sub_items, o.display_names, o.unit, o.scaling, o.object_index, o.depend_on_slot, o.depend_on_slot_group, o.overwritten_by_module, o.name, o.names, o.comments, o.type, o.bit_size, o.has_flags, o.access, o.read_restrictions, o.write_restrictions, o.category, o.pdo_mapping, o.safety_mapping, o.attribute, o.backup, o.setting, o.transition, o.sdo_access, o.flags_spelling, o.properties, o.xml, o.object_code, o.id AS object_id, l.position FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN profiles p ON p.device_id = d.id JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id JOIN objects o ON o.id = l.object_id;

CREATE VIEW device_object_entries AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, o.object_index, CASE WHEN o.object_index IS NOT NULL THEN printf('0x%04x', o.object_index) END AS object_index_hex, o.name AS object_name, e.subindex, e.name, e.data_type, e.base_type, e.bit_size, e.bit_offset, e.access, e.access_word, e.category, e.pdo_mapping, e.safety_mapping, e.default_raw, e.default_kind, e.default_int, e.default_real, e.default_text, e.min_int, e.min_real, e.max_int, e.max_real, e.unit, e.display_name, o.id AS object_id, l.position AS object_position, e.position FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN profiles p ON p.device_id = d.id JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries e ON e.object_id = o.id;

CREATE VIEW device_pdo_entries AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, p.direction, p.pdo_index, CASE WHEN p.pdo_index IS NOT NULL THEN printf('0x%04x', p.pdo_index) END AS pdo_index_hex, p.name AS pdo_name, p.sm, p.image_sm, CAST(CASE WHEN p.image_sm IS NOT NULL THEN 1 ELSE 0 END AS BIGINT) AS assigned_by_default, e.image_bit_offset, CAST(e.image_bit_offset >> 3 AS TEXT) || '.' || CAST(e.image_bit_offset & 7 AS TEXT) AS image_byte_bit, CASE WHEN e.entry_index IS NOT NULL THEN printf('0x%04x', e.entry_index) END AS entry_index_hex, e.entry_index, e.depend_on_slot, e.depend_on_slot_group, e.subindex, e.bit_length, e.name, e.names, e.comments, e.data_type, e.dscale, e.swap_data, e.fixed, e.safety_conn_number, e.ads_info, e.is_padding, CAST(CASE WHEN e.entry_index <> 0 THEN CASE WHEN upper(trim(e.data_type)) IN ('SINT', 'INT', 'DINT', 'LINT', 'INT24', 'INT40', 'INT48', 'INT56', 'INT8', 'INT16', 'INT32', 'INT64', 'INTEGER8', 'INTEGER16', 'INTEGER32', 'INTEGER64') THEN 1 WHEN upper(trim(e.data_type)) IN ('USINT', 'UINT', 'UDINT', 'ULINT', 'UINT24', 'UINT40', 'UINT48', 'UINT56', 'UINT8', 'UINT16', 'UINT32', 'UINT64', 'UNSIGNED8', 'UNSIGNED16', 'UNSIGNED32', 'UNSIGNED64') THEN 0 WHEN upper(trim(e.data_type)) IN ('BOOL', 'BYTE', 'WORD', 'DWORD', 'BIT1', 'BIT2', 'BIT3', 'BIT4', 'BIT5', 'BIT6', 'BIT7', 'BIT8', 'BIT9', 'BIT10', 'BIT11', 'BIT12', 'BIT13', 'BIT14', 'BIT15', 'BIT16', 'BITARR8', 'BITARR16', 'BITARR32', 'REAL', 'LREAL', 'TIME_OF_DAY', 'TIME_DIFFERENCE', 'DOMAIN', 'GUID', 'STRING', 'VISIBLE_STRING', 'OCTET_STRING', 'UNICODE_STRING', 'BOOLEAN', 'BIT', 'REAL32', 'REAL64', 'FLOAT', 'DOUBLE') THEN NULL WHEN upper(trim(e.data_type)) LIKE '%(%' OR upper(trim(e.data_type)) LIKE '%[%' THEN NULL ELSE (SELECT CASE WHEN upper(trim(z.base_type)) IN ('SINT', 'INT', 'DINT', 'LINT', 'INT24', 'INT40', 'INT48', 'INT56', 'INT8', 'INT16', 'INT32', 'INT64', 'INTEGER8', 'INTEGER16', 'INTEGER32', 'INTEGER64') THEN 1 WHEN upper(trim(z.base_type)) IN ('USINT', 'UINT', 'UDINT', 'ULINT', 'UINT24', 'UINT40', 'UINT48', 'UINT56', 'UINT8', 'UINT16', 'UINT32', 'UINT64', 'UNSIGNED8', 'UNSIGNED16', 'UNSIGNED32', 'UNSIGNED64') THEN 0 WHEN upper(trim(z.base_type)) IN ('BOOL', 'BYTE', 'WORD', 'DWORD', 'BIT1', 'BIT2', 'BIT3', 'BIT4', 'BIT5', 'BIT6', 'BIT7', 'BIT8', 'BIT9', 'BIT10', 'BIT11', 'BIT12', 'BIT13', 'BIT14', 'BIT15', 'BIT16', 'BITARR8', 'BITARR16', 'BITARR32', 'REAL', 'LREAL', 'TIME_OF_DAY', 'TIME_DIFFERENCE', 'DOMAIN', 'GUID', 'STRING', 'VISIBLE_STRING', 'OCTET_STRING', 'UNICODE_STRING', 'BOOLEAN', 'BIT', 'REAL32', 'REAL64', 'FLOAT', 'DOUBLE') THEN NULL WHEN upper(trim(z.base_type)) LIKE '%(%' OR upper(trim(z.base_type)) LIKE '%[%' THEN NULL ELSE NULL END FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.device_id = d.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) END END AS BIGINT) AS signed, (SELECT o.name FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.device_id = d.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS object_name, (SELECT z.name FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.device_id = d.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS object_entry_name, (SELECT CASE WHEN z.unit IS NOT NULL THEN printf('0x%08x', z.unit) END FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.device_id = d.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS unit_hex, (SELECT CAST(coalesce(CAST(z.min_int AS NUMERIC), CAST(z.min_real AS NUMERIC)) AS NUMERIC) FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.device_id = d.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS minimum, (SELECT CAST(coalesce(CAST(z.max_int AS NUMERIC), CAST(z.max_real AS NUMERIC)) AS NUMERIC) FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.device_id = d.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS maximum, CAST(CASE WHEN p.bit_size IS NOT NULL THEN (SELECT coalesce(sum(b.bit_length), 0) FROM pdo_entries b WHERE b.pdo_id = e.pdo_id AND b.position < e.position AND b.bit_length > 0) END AS BIGINT) AS bit_offset_in_pdo, p.id AS pdo_id, p.position AS pdo_position, e.position FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN pdos p ON p.device_id = d.id JOIN pdo_entries e ON e.pdo_id = p.id;

CREATE VIEW device_initcmds AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, CASE WHEN i.object_index IS NOT NULL THEN printf('0x%04x', i.object_index) END AS object_index_hex, i.protocol, i.transitions, i.object_index, i.depend_on_slot, i.depend_on_slot_group, i.subindex, i.idn, i.channel, i.eoe_type, i.data, i.adapt_automatically, i.comment, i.fixed, i.complete_access, i.overwritten_by_module, i.id AS initcmd_id, i.position FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN initcmds i ON i.device_id = d.id;

CREATE VIEW device_dc_modes AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, CASE WHEN c.assign_activate IS NOT NULL THEN printf('0x%04x', c.assign_activate) END AS assign_activate_hex, c.name, c.description, c.assign_activate, c.cycle_time_sync0_ns, c.cycle_time_sync0_factor, c.shift_time_sync0_ns, c.shift_time_sync0_factor, c.shift_time_sync0_input, c.shift_time_sync0_output_delay_ns, c.shift_time_sync0_input_delay_ns, c.cycle_time_sync1_ns, c.cycle_time_sync1_factor, c.shift_time_sync1_ns, c.shift_time_sync1_factor, c.shift_time_sync1_input, c.shift_time_sync1_output_delay_ns, c.shift_time_sync1_input_delay_ns, c.activate_additional, c.cycle_time_sync2_ns, c.cycle_time_sync2_factor, c.shift_time_sync2_ns, c.cycle_time_sync3_ns, c.cycle_time_sync3_factor, c.shift_time_sync3_ns, c.sm_assignments, c.dc_active, c.sync0, c.sync1, c.time_only, c.sync_unit_pdi, c.latch0_pdi, c.latch1_pdi, d.dc_time_loop_control_only, CAST(CASE WHEN c.position = d.default_op_mode THEN 1 ELSE 0 END AS BIGINT) AS is_default, c.id AS dc_mode_id, c.position FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN dc_modes c ON c.device_id = d.id;

CREATE VIEW module_objects AS SELECT m.id AS module_id, m.vendor_id, m.module_ident, CASE WHEN m.vendor_id IS NOT NULL THEN printf('0x%08x', m.vendor_id) END AS vendor_id_hex, CASE WHEN m.module_ident IS NOT NULL THEN printf('0x%08x', m.module_ident) END AS module_ident_hex, v.name AS vendor, m.type AS module_type, m.name AS module_name, p.position AS profile, CASE WHEN o.object_index IS NOT NULL THEN printf('0x%04x', o.object_index) END AS object_index_hex, o.default_string, o.min_data, o.max_data, o.default_data, o.min_value, o.max_value, o.default_value, o.info_sub_items, o.display_names, o.unit, o.scaling, o.object_index, o.depend_on_slot, o.depend_on_slot_group, o.overwritten_by_module, o.name, o.names, o.comments, o.type, o.bit_size, o.has_flags, o.access, o.read_restrictions, o.write_restrictions, o.category, o.pdo_mapping, o.safety_mapping, o.attribute, o.backup, o.setting, o.transition, o.sdo_access, o.flags_spelling, o.properties, o.xml, o.object_code, o.id AS object_id, l.position FROM modules m LEFT JOIN vendors v ON v.vendor_id = m.vendor_id JOIN profiles p ON p.module_id = m.id JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id JOIN objects o ON o.id = l.object_id;

CREATE VIEW module_object_entries AS SELECT m.id AS module_id, m.vendor_id, m.module_ident, CASE WHEN m.vendor_id IS NOT NULL THEN printf('0x%08x', m.vendor_id) END AS vendor_id_hex, CASE WHEN m.module_ident IS NOT NULL THEN printf('0x%08x', m.module_ident) END AS module_ident_hex, v.name AS vendor, m.type AS module_type, m.name AS module_name, o.object_index, CASE WHEN o.object_index IS NOT NULL THEN printf('0x%04x', o.object_index) END AS object_index_hex, o.name AS object_name, e.subindex, e.name, e.data_type, e.base_type, e.bit_size, e.bit_offset, e.access, e.access_word, e.category, e.pdo_mapping, e.safety_mapping, e.default_raw, e.default_kind, e.default_int, e.default_real, e.default_text, e.min_int, e.min_real, e.max_int, e.max_real, e.unit, e.display_name, o.id AS object_id, l.position AS object_position, e.position FROM modules m LEFT JOIN vendors v ON v.vendor_id = m.vendor_id JOIN profiles p ON p.module_id = m.id JOIN dictionary_objects l ON l.dictionary_id = p.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries e ON e.object_id = o.id;

CREATE VIEW module_pdo_entries AS SELECT m.id AS module_id, m.vendor_id, m.module_ident, CASE WHEN m.vendor_id IS NOT NULL THEN printf('0x%08x', m.vendor_id) END AS vendor_id_hex, CASE WHEN m.module_ident IS NOT NULL THEN printf('0x%08x', m.module_ident) END AS module_ident_hex, v.name AS vendor, m.type AS module_type, m.name AS module_name, p.direction, p.pdo_index, CASE WHEN p.pdo_index IS NOT NULL THEN printf('0x%04x', p.pdo_index) END AS pdo_index_hex, p.name AS pdo_name, p.sm, CASE WHEN e.entry_index IS NOT NULL THEN printf('0x%04x', e.entry_index) END AS entry_index_hex, e.entry_index, e.depend_on_slot, e.depend_on_slot_group, e.subindex, e.bit_length, e.name, e.names, e.comments, e.data_type, e.dscale, e.swap_data, e.fixed, e.safety_conn_number, e.ads_info, e.is_padding, CAST(CASE WHEN e.entry_index <> 0 THEN CASE WHEN upper(trim(e.data_type)) IN ('SINT', 'INT', 'DINT', 'LINT', 'INT24', 'INT40', 'INT48', 'INT56', 'INT8', 'INT16', 'INT32', 'INT64', 'INTEGER8', 'INTEGER16', 'INTEGER32', 'INTEGER64') THEN 1 WHEN upper(trim(e.data_type)) IN ('USINT', 'UINT', 'UDINT', 'ULINT', 'UINT24', 'UINT40', 'UINT48', 'UINT56', 'UINT8', 'UINT16', 'UINT32', 'UINT64', 'UNSIGNED8', 'UNSIGNED16', 'UNSIGNED32', 'UNSIGNED64') THEN 0 WHEN upper(trim(e.data_type)) IN ('BOOL', 'BYTE', 'WORD', 'DWORD', 'BIT1', 'BIT2', 'BIT3', 'BIT4', 'BIT5', 'BIT6', 'BIT7', 'BIT8', 'BIT9', 'BIT10', 'BIT11', 'BIT12', 'BIT13', 'BIT14', 'BIT15', 'BIT16', 'BITARR8', 'BITARR16', 'BITARR32', 'REAL', 'LREAL', 'TIME_OF_DAY', 'TIME_DIFFERENCE', 'DOMAIN', 'GUID', 'STRING', 'VISIBLE_STRING', 'OCTET_STRING', 'UNICODE_STRING', 'BOOLEAN', 'BIT', 'REAL32', 'REAL64', 'FLOAT', 'DOUBLE') THEN NULL WHEN upper(trim(e.data_type)) LIKE '%(%' OR upper(trim(e.data_type)) LIKE '%[%' THEN NULL ELSE (SELECT CASE WHEN upper(trim(z.base_type)) IN ('SINT', 'INT', 'DINT', 'LINT', 'INT24', 'INT40', 'INT48', 'INT56', 'INT8', 'INT16', 'INT32', 'INT64', 'INTEGER8', 'INTEGER16', 'INTEGER32', 'INTEGER64') THEN 1 WHEN upper(trim(z.base_type)) IN ('USINT', 'UINT', 'UDINT', 'ULINT', 'UINT24', 'UINT40', 'UINT48', 'UINT56', 'UINT8', 'UINT16', 'UINT32', 'UINT64', 'UNSIGNED8', 'UNSIGNED16', 'UNSIGNED32', 'UNSIGNED64') THEN 0 WHEN upper(trim(z.base_type)) IN ('BOOL', 'BYTE', 'WORD', 'DWORD', 'BIT1', 'BIT2', 'BIT3', 'BIT4', 'BIT5', 'BIT6', 'BIT7', 'BIT8', 'BIT9', 'BIT10', 'BIT11', 'BIT12', 'BIT13', 'BIT14', 'BIT15', 'BIT16', 'BITARR8', 'BITARR16', 'BITARR32', 'REAL', 'LREAL', 'TIME_OF_DAY', 'TIME_DIFFERENCE', 'DOMAIN', 'GUID', 'STRING', 'VISIBLE_STRING', 'OCTET_STRING', 'UNICODE_STRING', 'BOOLEAN', 'BIT', 'REAL32', 'REAL64', 'FLOAT', 'DOUBLE') THEN NULL WHEN upper(trim(z.base_type)) LIKE '%(%' OR upper(trim(z.base_type)) LIKE '%[%' THEN NULL ELSE NULL END FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.module_id = m.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) END END AS BIGINT) AS signed, (SELECT o.name FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.module_id = m.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS object_name, (SELECT z.name FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.module_id = m.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS object_entry_name, (SELECT CASE WHEN z.unit IS NOT NULL THEN printf('0x%08x', z.unit) END FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.module_id = m.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS unit_hex, (SELECT CAST(coalesce(CAST(z.min_int AS NUMERIC), CAST(z.min_real AS NUMERIC)) AS NUMERIC) FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.module_id = m.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS minimum, (SELECT CAST(coalesce(CAST(z.max_int AS NUMERIC), CAST(z.max_real AS NUMERIC)) AS NUMERIC) FROM profiles q JOIN dictionary_objects l ON l.dictionary_id = q.dictionary_id JOIN objects o ON o.id = l.object_id JOIN object_entries z ON z.object_id = o.id WHERE q.module_id = m.id AND e.entry_index <> 0 AND o.object_index = e.entry_index AND z.subindex = CASE WHEN e.subindex IS NULL AND e.spelling LIKE '%"subindex":"%' AND e.spelling NOT LIKE '%"subindex":""%' THEN NULL ELSE coalesce(e.subindex, 0) END ORDER BY q.position, l.position LIMIT 1) AS maximum, CAST(CASE WHEN p.bit_size IS NOT NULL THEN (SELECT coalesce(sum(b.bit_length), 0) FROM pdo_entries b WHERE b.pdo_id = e.pdo_id AND b.position < e.position AND b.bit_length > 0) END AS BIGINT) AS bit_offset_in_pdo, p.id AS pdo_id, p.position AS pdo_position, e.position FROM modules m LEFT JOIN vendors v ON v.vendor_id = m.vendor_id JOIN pdos p ON p.module_id = m.id JOIN pdo_entries e ON e.pdo_id = p.id;

CREATE VIEW module_initcmds AS SELECT m.id AS module_id, m.vendor_id, m.module_ident, CASE WHEN m.vendor_id IS NOT NULL THEN printf('0x%08x', m.vendor_id) END AS vendor_id_hex, CASE WHEN m.module_ident IS NOT NULL THEN printf('0x%08x', m.module_ident) END AS module_ident_hex, v.name AS vendor, m.type AS module_type, m.name AS module_name, CASE WHEN i.object_index IS NOT NULL THEN printf('0x%04x', i.object_index) END AS object_index_hex, i.protocol, i.transitions, i.object_index, i.depend_on_slot, i.depend_on_slot_group, i.subindex, i.idn, i.channel, i.eoe_type, i.data, i.adapt_automatically, i.comment, i.fixed, i.complete_access, i.overwritten_by_module, i.id AS initcmd_id, i.position FROM modules m LEFT JOIN vendors v ON v.vendor_id = m.vendor_id JOIN initcmds i ON i.module_id = m.id;

CREATE VIEW device_drive_modes AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, CASE WHEN m.module_ident IS NOT NULL THEN printf('0x%08x', m.module_ident) END AS module_ident_hex, CASE WHEN m.rx_pdo_index IS NOT NULL THEN printf('0x%04x', m.rx_pdo_index) END AS rx_pdo_index_hex, m.axis, m.mode, m.kind, m.verdict, m.score, m.conflict, m.evidence, m.module_ident, m.module_is_default, m.rx_pdo_index, m.rx_pdo_is_default, m.op_mode, m.recipe, m.position FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN drive_modes m ON m.device_id = d.id;

CREATE VIEW device_mode_evidence AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, CASE WHEN m.module_ident IS NOT NULL THEN printf('0x%08x', m.module_ident) END AS module_ident_hex, CASE WHEN m.object_index IS NOT NULL THEN printf('0x%04x', m.object_index) END AS object_index_hex, CASE WHEN m.pdo_index IS NOT NULL THEN printf('0x%04x', m.pdo_index) END AS pdo_index_hex, m.axis, m.module_ident, m.mode, m.rank, m.wording, m.score, m.polarity, m.conflict, m.object_index, m.pdo_index, m.evidence, m.position FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN mode_evidence m ON m.device_id = d.id;

CREATE VIEW device_capabilities AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, f.output_bytes, f.input_bytes, f.dc_supported, f.dc_needed, f.runs_without_dc, f.supports_sync0, f.supports_sync1, f.uses_latch, f.output_sync_types, f.input_sync_types, f.min_cycle_ns, f.axis_count, f.has_bootstrap, f.image_signature, f.pdo_signature, f.fsoe, f.fsoe_evidence FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN device_facts f ON f.device_id = d.id;

CREATE VIEW device_revisions AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, r.previous_id, CAST(CASE WHEN r.previous_id IS NULL THEN 0 WHEN coalesce(f.image_signature, '') <> coalesce(b.image_signature, '') THEN 1 WHEN f.output_bytes IS NOT NULL AND f.input_bytes IS NOT NULL AND b.output_bytes IS NOT NULL AND b.input_bytes IS NOT NULL THEN 0 END AS BIGINT) AS layout_changed, f.output_bytes, f.input_bytes, f.image_signature FROM (SELECT n.id, CAST(coalesce((SELECT o.id FROM devices o WHERE o.vendor_id = n.vendor_id AND o.product_code = n.product_code AND o.type = n.type AND o.variant = 1 AND o.revision_no < n.revision_no ORDER BY o.revision_no DESC LIMIT 1), (SELECT o.id FROM devices o WHERE o.vendor_id = n.vendor_id AND o.product_code = n.product_code AND o.variant = 1 AND o.revision_no < n.revision_no ORDER BY o.revision_no DESC LIMIT 1)) AS BIGINT) AS previous_id FROM devices n WHERE n.variant = 1 AND n.vendor_id IS NOT NULL AND n.product_code IS NOT NULL) r JOIN devices d ON d.id = r.id LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN device_facts f ON f.device_id = d.id LEFT JOIN device_facts b ON b.device_id = r.previous_id;

CREATE VIEW same_process_image_layout AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, o.id AS other_device_id, CASE WHEN o.vendor_id IS NOT NULL THEN printf('0x%08x', o.vendor_id) END AS other_vendor_id_hex, CASE WHEN o.product_code IS NOT NULL THEN printf('0x%08x', o.product_code) END AS other_product_code_hex, CASE WHEN o.revision_no IS NOT NULL THEN printf('0x%08x', o.revision_no) END AS other_revision_no_hex, o.type AS other_type, CAST(CASE WHEN f.pdo_signature = g.pdo_signature THEN 1 WHEN coalesce(f.pdo_signature, g.pdo_signature) IS NOT NULL THEN 0 END AS BIGINT) AS same_pdo_set, f.output_bytes, f.input_bytes FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN device_facts f ON f.device_id = d.id JOIN device_facts g ON g.image_signature = f.image_signature JOIN devices o ON o.id = g.device_id WHERE o.id <> d.id AND o.variant = 1 AND f.output_bytes IS NOT NULL AND f.input_bytes IS NOT NULL;

CREATE VIEW drive_modes_by_vendor AS SELECT d.vendor_id, coalesce(d.own_vendor_name, v.name) AS vendor, CAST(count(DISTINCT d.id) AS BIGINT) AS drives, CAST(count(DISTINCT CASE WHEN m.mode = 'PP' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS pp, CAST(count(DISTINCT CASE WHEN m.mode = 'VL' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS vl, CAST(count(DISTINCT CASE WHEN m.mode = 'PV' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS pv, CAST(count(DISTINCT CASE WHEN m.mode = 'TQ' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS tq, CAST(count(DISTINCT CASE WHEN m.mode = 'HM' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS hm, CAST(count(DISTINCT CASE WHEN m.mode = 'IP' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS ip, CAST(count(DISTINCT CASE WHEN m.mode = 'CSP' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS csp, CAST(count(DISTINCT CASE WHEN m.mode = 'CSV' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS csv, CAST(count(DISTINCT CASE WHEN m.mode = 'CST' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS cst, CAST(count(DISTINCT CASE WHEN m.mode = 'CSTCA' AND m.verdict IN ('yes', 'likely') THEN d.id END) AS BIGINT) AS cstca FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id JOIN drive_modes m ON m.device_id = d.id AND m.kind = 'CiA 402' WHERE d.variant = 1 AND d.hidden = 0 GROUP BY d.vendor_id, coalesce(d.own_vendor_name, v.name);

CREATE VIEW ingest_problems AS SELECT s.id AS source_id, s.member, s.status, 'document' AS rule, CASE s.status WHEN 'failed' THEN 'E' WHEN 'recovered' THEN 'W' ELSE 'I' END AS severity, s.message, CAST(0 AS BIGINT) AS line FROM sources s WHERE s.status <> 'stored' UNION ALL SELECT s.id, s.member, s.status, f.rule, f.severity, f.message, f.line FROM findings f JOIN sources s ON s.id = f.source_id WHERE f.severity = 'E';

CREATE VIEW conflicting_descriptions AS SELECT d.id AS device_id, d.vendor_id, d.product_code, d.revision_no, d.variant, CASE WHEN d.vendor_id IS NOT NULL THEN printf('0x%08x', d.vendor_id) END AS vendor_id_hex, CASE WHEN d.product_code IS NOT NULL THEN printf('0x%08x', d.product_code) END AS product_code_hex, CASE WHEN d.revision_no IS NOT NULL THEN printf('0x%08x', d.revision_no) END AS revision_no_hex, CASE WHEN d.vendor_id = 2 AND d.revision_no IS NOT NULL THEN CASE WHEN (d.revision_no & 65535) <> 0 THEN printf('-%04d', (d.revision_no & 65535)) ELSE '' END || printf('-%04d', (d.revision_no >> 16)) END AS revision_text, d.hidden, coalesce(d.own_vendor_name, v.name) AS vendor, d.type AS device_type, d.name AS device_name, d.element_count, d.recovered, d.file_version, (SELECT min(s.member) FROM device_sources x JOIN sources s ON s.id = x.source_id WHERE x.device_id = d.id) AS first_source, CAST((SELECT count(DISTINCT x.source_id) FROM device_sources x WHERE x.device_id = d.id) AS BIGINT) AS sources FROM devices d LEFT JOIN vendors v ON v.vendor_id = d.vendor_id WHERE d.product_code IS NOT NULL AND d.revision_no IS NOT NULL AND EXISTS (SELECT 1 FROM devices o WHERE o.vendor_id = d.vendor_id AND o.product_code = d.product_code AND o.revision_no = d.revision_no AND o.variant <> d.variant);

CREATE VIRTUAL TABLE device_search USING fts5(vendor, type, name, identity, words, tokenize = 'unicode61 remove_diacritics 2');

INSERT INTO alembic_version (version_num) VALUES ('0015')
