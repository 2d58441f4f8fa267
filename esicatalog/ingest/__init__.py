"""From folders and archives into the catalog: find documents, parse in worker processes, hand rows to one writer."""
