#!/usr/bin/env python3
"""Writes the pictures under seeds/: small and valid, one for each encoding that the decoders support."""

import gzip
import io
import struct
import tarfile
import zipfile
import zlib
from pathlib import Path

SEEDS = Path(__file__).parent / "seeds"


def write(name, data):
    path = SEEDS / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


# PNG

def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, depth, color, rows, extra=b"", interlace=0):
    header = struct.pack(">IIBBBBB", width, height, depth, color, 0, 0, interlace)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra +
            chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def make_png():
    palette = chunk(b"PLTE", bytes([255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9]))
    write("image_png/rgb8.png", png(3, 2, 8, 2, b"\0" + bytes(range(9)) + b"\1" + bytes(range(9))))
    write("image_png/rgba8.png", png(2, 2, 8, 6, b"\2" + bytes(range(8)) + b"\3" + bytes(range(8))))
    write("image_png/rgb16.png", png(1, 2, 16, 2, b"\4" + bytes(range(6)) + b"\0" + bytes(range(6))))
    write("image_png/gray1.png", png(9, 2, 1, 0, b"\0\xaa\x80\0\x55\0"))
    write("image_png/gray4_trns.png", png(2, 1, 4, 0, b"\0\x5a", chunk(b"tRNS", b"\0\5")))
    write("image_png/gray_alpha.png", png(2, 1, 8, 4, b"\0\1\2\3\4"))
    write("image_png/palette2.png", png(4, 1, 2, 3, b"\0\x1b", palette + chunk(b"tRNS", b"\x80")))
    write("image_png/extras.png", png(1, 1, 8, 2, b"\0abc",
          chunk(b"gAMA", struct.pack(">I", 45455)) + chunk(b"sRGB", b"\0") +
          chunk(b"tEXt", b"k\0v") + chunk(b"pHYs", bytes(9))))
    passes = b"\0abc" + b"\0def" + b"\0ghi"  # Adam7 of 2x2: the first pass, the sixth, the seventh
    write("image_png/interlaced.png", png(2, 2, 8, 2, passes + b"jkl", interlace=1))


# JPEG: a two-bit code for three sizes of differences, and for four runs.

def segment(marker, data):
    return bytes([0xFF, marker]) + struct.pack(">H", len(data) + 2) + data


def huffman(identity, symbols):
    counts = [0, min(3, len(symbols)), max(0, len(symbols) - 3)] + [0] * 13
    return bytes([identity] + counts + symbols)


def jpeg(frame, components, width, height, scans, extra=b""):
    tables = segment(0xDB, bytes([0] + [1 + i // 8 for i in range(64)]))
    part = b"".join(bytes([i + 1, s, 0]) for i, s in enumerate(components))
    size = struct.pack(">BHHB", 8, height, width, len(components))
    codes = segment(0xC4, huffman(0x00, [0, 3, 5]) + huffman(0x10, [0, 1, 0xF0, 0x11]))
    body = b"".join(segment(0xDA, head) + data for head, data in scans)
    return b"\xff\xd8" + extra + tables + segment(frame, size + part) + codes + body + b"\xff\xd9"


def scan(components, first=0, last=63, approx=0):
    return bytes([len(components)]) + b"".join(bytes([c, 0]) for c in components) + \
        bytes([first, last, approx])


def make_jpeg():
    jfif = segment(0xE0, b"JFIF\0\1\1\0\0\1\0\1\0\0")
    adobe = segment(0xEE, b"Adobe\0\x64\0\0\0\0\2")
    data = bytes([0x4A, 0x12, 0x94, 0x20] * 6)
    write("image_jpeg/gray.jpg", jpeg(0xC0, [0x11], 8, 8, [(scan([1]), data)], jfif))
    write("image_jpeg/color.jpg", jpeg(0xC0, [0x11] * 3, 9, 8, [(scan([1, 2, 3]), data)], jfif))
    write("image_jpeg/subsampled.jpg",
          jpeg(0xC0, [0x22, 0x11, 0x11], 17, 9, [(scan([1, 2, 3]), data * 2)], jfif))
    write("image_jpeg/four.jpg", jpeg(0xC0, [0x11] * 4, 8, 8, [(scan([1, 2, 3, 4]), data)], adobe))
    write("image_jpeg/restarts.jpg", jpeg(0xC1, [0x11], 16, 8,
          [(scan([1]), data[:4] + b"\xff\xd0" + data[:4])], segment(0xDD, b"\0\1")))
    write("image_jpeg/progressive.jpg", jpeg(0xC2, [0x11], 8, 8,
          [(scan([1], 0, 0, 1), data[:2]), (scan([1], 0, 0, 0x10), b"\x80"),
           (scan([1], 1, 5, 2), data[:4]), (scan([1], 1, 5, 0x21), data[:6])], jfif))


# GIF

def lzw(bits, pixels):
    """Only codes of bits + 1 bits: clears the table before they would grow."""
    clear, end = 1 << bits, (1 << bits) + 1
    codes = []
    for i, pixel in enumerate(pixels):
        if i % ((1 << bits) - 2) == 0:
            codes.append(clear)
        codes.append(pixel)
    codes.append(end)
    value = sum(code << (i * (bits + 1)) for i, code in enumerate(codes))
    packed = value.to_bytes((len(codes) * (bits + 1) + 7) // 8, "little")
    return bytes([bits, len(packed)]) + packed + b"\0"


def make_gif():
    colors = bytes([255, 0, 0, 0, 255, 0, 0, 0, 255, 7, 7, 7])
    screen = struct.pack("<HHBBB", 4, 3, 0x91, 1, 0)
    control = b"\x21\xf9\x04\x01\x0a\0\2\0"
    pixels = lzw(2, [0, 1, 2, 3] * 3)

    def image(x, y, w, h, flags=0):
        return b"\x2c" + struct.pack("<HHHHB", x, y, w, h, flags)

    write("image_gif/plain.gif", b"GIF87a" + screen + colors + image(0, 0, 4, 3) + pixels + b";")
    write("image_gif/interlaced.gif",
          b"GIF89a" + screen + colors + control + image(0, 0, 4, 3, 0x40) + pixels + b";")
    write("image_gif/local.gif", b"GIF89a" + struct.pack("<HHBBB", 4, 3, 0, 0, 0) +
          b"\x21\xff\x0bNETSCAPE2.0\3\1\0\0\0" + b"\x21\xfe\2hi\0" + image(1, 1, 2, 2, 0x81) + colors +
          lzw(2, [0, 1, 2, 3]) + image(0, 0, 1, 1) + lzw(2, [0]) + b";")


# TGA

def tga(kind, bits, data, width=3, height=2, flags=0, palette=b"", palette_bits=0):
    count = len(palette) * 8 // palette_bits if palette_bits else 0
    return struct.pack("<BBBHHBHHHHBB", 2, bool(palette), kind, 0, count, palette_bits, 0, 0, width,
                       height, bits, flags) + b"id" + palette + data


def make_tga():
    write("image_tga/rgb24.tga", tga(2, 24, bytes(range(18))))
    write("image_tga/rgba32_top.tga", tga(2, 32, bytes(range(24)), flags=0x28))
    write("image_tga/rgb16.tga", tga(2, 16, bytes(range(12)), flags=0x10))
    write("image_tga/gray.tga", tga(3, 8, bytes(range(6))))
    write("image_tga/palette.tga", tga(1, 8, bytes([0, 1, 2, 2, 1, 0]), palette=bytes(range(9)),
                                       palette_bits=24))
    write("image_tga/rle24.tga", tga(10, 24, b"\x82abc\2defghijkl"))
    write("image_tga/rle_gray.tga", tga(11, 8, b"\x85a") + bytes(8) + b"TRUEVISION-XFILE.\0")
    write("image_tga/rle_palette.tga", tga(9, 8, b"\x83\0\1\1\2", palette=bytes(range(12)),
                                           palette_bits=32))


# BMP

def bmp(bits, data, width=3, height=2, compression=0, palette=b"", header=40, extra=b""):
    info = struct.pack("<IiiHHIIiiII", header, width, height, 1, bits, compression, len(data), 0, 0,
                       len(palette) // 4, 0) + extra
    offset = 14 + len(info) + len(palette)
    return b"BM" + struct.pack("<IHHI", offset + len(data), 0, 0, offset) + info + palette + data


def make_bmp():
    colors = bytes(range(64))
    masks = struct.pack("<III", 0xF800, 0x07E0, 0x001F)
    write("image_bmp/rgb24.bmp", bmp(24, bytes(range(24))))
    write("image_bmp/rgb32_top.bmp", bmp(32, bytes(range(24)), height=-2))
    write("image_bmp/palette8.bmp", bmp(8, bytes([0, 1, 2, 0, 3, 4, 5, 0]), palette=colors))
    write("image_bmp/palette4.bmp", bmp(4, b"\x12\x30\0\0\x21\0\0\0", palette=colors))
    write("image_bmp/palette1.bmp", bmp(1, b"\xa0\0\0\0\x40\0\0\0", palette=colors[:8]))
    write("image_bmp/rgb555.bmp", bmp(16, bytes(range(16))))
    write("image_bmp/rgb565.bmp", bmp(16, bytes(range(16)), compression=3, extra=masks))
    write("image_bmp/rle8.bmp", bmp(8, b"\3\1\0\0\0\3\2\1\0\0\0\1", compression=1, palette=colors))
    write("image_bmp/rle4.bmp", bmp(4, b"\3\x12\0\2\0\1\0\1", compression=2, palette=colors))
    write("image_bmp/v5.bmp", bmp(32, bytes(range(24)), compression=3, header=124,
          extra=struct.pack("<IIII", 0xFF0000, 0xFF00, 0xFF, 0xFF000000) + bytes(68)))
    write("image_bmp/core.bmp", b"BM" + struct.pack("<IHHI", 50, 0, 0, 26) +
          struct.pack("<IHHHH", 12, 3, 2, 1, 24) + bytes(range(24)))


# PPM, PGM and PFM

def make_pnm():
    write("image_pnm/binary.ppm", b"P6\n3 2\n255\n" + bytes(range(18)))
    write("image_pnm/binary16.pgm", b"P5 3 1 1000\n\0\1\1\2\3\xe8")
    write("image_pnm/text.ppm", b"P3 # color\n2 1\n15\n0 7 15 1\t2 3\n")
    write("image_pnm/text.pgm", b"P2\n2 2\n9\n0 1 2#three\n9")
    for order in "<>":
        scale = b"-1.0" if order == "<" else b"1.0"
        name = "little" if order == "<" else "big"
        write(f"image_pnm/{name}.pfm", b"PF\n2 1\n" + scale + b"\n" + struct.pack(order + "6f", *range(6)))
        write(f"image_pnm/{name}_gray.pfm",
              b"Pf\n2 1\n" + scale + b"\n" + struct.pack(order + "2f", float("nan"), float("inf")))


# EXR: what OpenEXR wrote for the tests of asset

def make_exr():
    for path in sorted((Path(__file__).parents[1] / "fixtures/pictures").glob("*.exr")):
        write(f"image_exr/{path.name}", path.read_bytes())


# Items of stores

def make_band():
    def attribute(name, kind, value):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

    width, height, first, rows = 5, 40, 16, 20
    channels = b"".join(c + b"\0" + struct.pack("<iiii", kind, 0, 1, 1)
                        for c, kind in ((b"B", 2), (b"G", 2), (b"R", 2), (b"object-id.ID", 0))) + b"\0"
    header = (struct.pack("<ii", 20000630, 2) + attribute("channels", "chlist", channels)
              + attribute("compression", "compression", b"\3")
              + attribute("dataWindow", "box2i", struct.pack("<4i", 0, first, width - 1, first + rows - 1))
              + attribute("displayWindow", "box2i", struct.pack("<4i", 0, 0, width - 1, height - 1))
              + attribute("lineOrder", "lineOrder", b"\0")
              + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
              + attribute("scenefile", "string", b"scenefile item 1: scene=1f samples=16 sum=0123456789abcdef")
              + attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
              + attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0")
    blocks, places = b"", b""
    for y in range(first, first + rows, 16):
        size = min(16, first + rows - y) * width * 16
        places += struct.pack("<Q", len(header) + 16 + len(blocks))
        blocks += struct.pack("<ii", y, size) + struct.pack(f"<{size // 4}f", *(i / 9 for i in range(size // 4)))
    write("band/stored", header + places + blocks)
    write("band/cut_off", (header + places + blocks)[:-100])
    write("band/text", b"scenefile item 1: a=1 b= sum=0000000000000000")


def make_student():
    write("student/none", b'{"key": "", "student": {"name": "ann", "pictures": [], "unmatched": ["a.png", {"base64": "gA=="}]}}')
    measures = ("comparable linear".split(), "width height right_width right_height".split(),
                "psnr_db mean max share_over ssim flip_mean flip_max".split())
    values = {**{n: "true" for n in measures[0]}, **{n: "7" for n in measures[1]}, **{n: "0.25" for n in measures[2]}}
    values["psnr_db"] = '"inf"'
    claim = '{"cause": 3, "what": "w", "evidence": "e", "explained": 0.5, "said": false}'
    write("student/picture", ('{"student": {"name": "ben", "unmatched": [], "pictures": [{"name": "ball", "verdict": 1, "measures": {'
                              + ", ".join(f'"{n}": {v}' for n, v in values.items())
                              + '}, "reasons": ["r"], "causes": [' + claim + '], "rivals": [], "partial": [], "notes": [], '
                              '"png": {"base64": "iVBORw=="}, "png_file": "", "fingerprint": 18446744073709551615, "identical": ""}]}}').encode())


# Archives

def make_archive():
    files = [("a/b.png", b"picture " * 20), ("../c.png", b"c"), ("__MACOSX/d", b"d")]
    for name, method in (("stored.zip", zipfile.ZIP_STORED), ("deflated.zip", zipfile.ZIP_DEFLATED)):
        out = io.BytesIO()
        with zipfile.ZipFile(out, "w", method) as archive:
            for path, data in files:
                archive.writestr(zipfile.ZipInfo(path), data, method)
        write("archive/" + name, out.getvalue())
    for name, form in (("ustar.tar", tarfile.USTAR_FORMAT), ("gnu.tar", tarfile.GNU_FORMAT),
                       ("pax.tar", tarfile.PAX_FORMAT)):
        out = io.BytesIO()
        with tarfile.open(fileobj=out, mode="w", format=form) as archive:
            long = [] if form == tarfile.USTAR_FORMAT else [("long" * 40 + ".png", b"long")]
            for path, data in files + long:
                info = tarfile.TarInfo(path)
                info.size = len(data)
                archive.addfile(info, io.BytesIO(data))
            link = tarfile.TarInfo("link.png")
            link.type, link.linkname = tarfile.SYMTYPE, "/etc/passwd"
            archive.addfile(link)
        data = out.getvalue()
        data = data[:len(data.rstrip(b"\0")) // 512 * 512 + 1536]
        write("archive/" + name, data)
        write("archive/" + name + ".gz", gzip.compress(data, mtime=0))


make_archive()
make_band()
make_student()
make_png()
make_jpeg()
make_gif()
make_tga()
make_bmp()
make_pnm()
make_exr()
