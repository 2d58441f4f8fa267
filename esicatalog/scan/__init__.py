"""What EtherCAT masters print about a bus, read into records: scans, PDO lists, object dictionaries, ENI files."""
