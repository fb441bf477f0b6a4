//! A zip archive of files as they are (PKWARE APPNOTE, method 0). Code that compresses would add 30 kB to the page.

/// The archive of files by their names. Together they have less than 4 GiB.
pub fn archive<'a>(files: impl Iterator<Item = (&'a str, &'a [u8])>) -> Vec<u8> {
    let (mut archive, mut directory) = (Vec::new(), Vec::new());
    let mut entries: u16 = 0;
    for (name, bytes) in files {
        let header = header(name, bytes);
        let offset = archive.len() as u32;
        archive.extend(b"PK\x03\x04");
        archive.extend(&header);
        archive.extend(name.as_bytes());
        archive.extend(bytes);
        // Made by version 2.0; no comment, disk number or attributes.
        directory.extend(b"PK\x01\x02\x14\0");
        directory.extend(&header);
        directory.extend([0; 10]);
        directory.extend(offset.to_le_bytes());
        directory.extend(name.as_bytes());
        entries += 1;
    }
    let start = archive.len() as u32;
    archive.extend(&directory);
    archive.extend(b"PK\x05\x06\0\0\0\0");
    archive.extend([entries.to_le_bytes(), entries.to_le_bytes()].concat());
    archive.extend([(directory.len() as u32).to_le_bytes(), start.to_le_bytes()].concat());
    archive.extend([0; 2]);
    archive
}

/// The part of a header that stands before the file and in the directory: version 2.0, name in UTF-8, stored, 1 January 1980.
fn header(name: &str, bytes: &[u8]) -> Vec<u8> {
    let size = (bytes.len() as u32).to_le_bytes();
    let mut header = b"\x14\0\0\x08\0\0\0\0\x21\0".to_vec();
    header.extend(checksum(bytes).to_le_bytes());
    header.extend([size, size].concat());
    header.extend((name.len() as u16).to_le_bytes());
    header.extend([0; 2]);
    header
}

/// CRC-32 of zip archives.
fn checksum(bytes: &[u8]) -> u32 {
    let bit = |crc: u32, _| (crc >> 1) ^ (0xedb8_8320 & 0u32.wrapping_sub(crc & 1));
    let byte = |crc: u32, byte: &u8| (0..8).fold(crc ^ u32::from(*byte), bit);
    !bytes.iter().fold(!0, byte)
}
