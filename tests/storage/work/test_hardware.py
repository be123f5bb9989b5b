"""What tells PCs apart that were made from one disk image: hardware that stays in the PC, read from faked folders."""

from pathlib import Path

import pytest

from storage.work import hardware
from storage.work.hardware import hardware_ids, is_other_hardware


class FakePc:
    """The folders in which Linux lists hardware."""

    def __init__(self, folder: Path) -> None:
        self.system, self.devices = folder / "sys", folder / "dev"
        for made in (self.system / "class" / "net", self.system / "class" / "block"):
            made.mkdir(parents=True)
        (self.devices / "disk" / "by-id").mkdir(parents=True)

    def add_card(
        self, name: str, address: str, *, kind: str = "0", bus: str | None = "pci0"
    ) -> None:
        card = self.system / "class" / "net" / name
        card.mkdir()
        (card / "address").write_text(f"{address}\n")
        (card / "addr_assign_type").write_text(f"{kind}\n")
        if bus:
            self._attach(card, bus, name)

    def add_disk(
        self, link: str, name: str, *, removable: int = 0, kind: str = "", bus: str = "pci0"
    ) -> None:
        disk = self.system / "class" / "block" / name
        disk.mkdir(exist_ok=True)
        (disk / "removable").write_text(f"{removable}\n")
        if name[-1].isdigit() and name.startswith("sd"):
            (disk / "partition").write_text("1\n")
        self._attach(disk, bus, name)
        (disk / "device" / "type").write_text(f"{kind}\n")
        (self.devices / name).touch()
        (self.devices / "disk" / "by-id" / link).symlink_to(f"../../{name}")

    def _attach(self, entry: Path, bus: str, name: str) -> None:
        device = self.system / "devices" / bus / name
        device.mkdir(parents=True, exist_ok=True)
        (entry / "device").symlink_to(device)


@pytest.fixture
def fake_pc(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> FakePc:
    pc = FakePc(tmp_path)
    monkeypatch.setattr(hardware, "_SYSTEM", pc.system)
    monkeypatch.setattr(hardware, "_DEVICES", pc.devices)
    monkeypatch.setattr("sys.platform", "linux")
    hardware_ids.cache_clear()
    monkeypatch.setattr(hardware, "hardware_ids", hardware_ids.__wrapped__)
    return pc


def test_built_in_cards_and_disks_identify_a_pc(fake_pc: FakePc) -> None:
    fake_pc.add_card("enp2s0", "00:1e:c9:00:00:01")
    fake_pc.add_card("wlp3s0", "00:1e:c9:00:00:02")
    fake_pc.add_disk("ata-KINGSTON_50026B1", "sda")
    fake_pc.add_disk("ata-KINGSTON_50026B1-part1", "sda1")
    fake_pc.add_disk("nvme-WD_2131", "nvme0n1")
    assert hardware.hardware_ids() == {
        "network": ["00:1e:c9:00:00:01", "00:1e:c9:00:00:02"],
        "disk": ["ata-KINGSTON_50026B1", "nvme-WD_2131"],
    }


def test_what_is_plugged_in_or_virtual_does_not_count(fake_pc: FakePc) -> None:
    fake_pc.add_card("lo", "00:00:00:00:00:00")
    fake_pc.add_card("docker0", "02:42:00:00:00:01", kind="3", bus=None)
    fake_pc.add_card("enx1", "00:1e:c9:00:00:03", bus="pci0/usb1")
    fake_pc.add_card("wlp3s0", "7a:00:00:00:00:01", kind="3")
    fake_pc.add_disk("usb-SanDisk_1", "sdb", bus="pci0/usb1")
    fake_pc.add_disk("ata-Bridge_2", "sdc", bus="pci0/usb1")
    fake_pc.add_disk("ata-DVD_3", "sr0", removable=1)
    fake_pc.add_disk("mmc-SC16G_4", "mmcblk0", kind="SD")
    fake_pc.add_disk("ata-QEMU_HARDDISK_QM00001", "sdd")
    fake_pc.add_disk("dm-uuid-LVM-5", "dm-0")
    assert hardware.hardware_ids() == {}


def test_a_system_without_these_folders_has_no_hardware_to_tell(
    tmp_path: Path, fake_pc: FakePc, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(hardware, "_SYSTEM", tmp_path / "none")
    monkeypatch.setattr(hardware, "_DEVICES", tmp_path / "none")
    assert hardware.hardware_ids() == {}


ONE = {"network": ["a", "b"], "disk": ["x"]}


@pytest.mark.parametrize(
    ("other", "is_other"),
    [
        ({"network": ["b"], "disk": ["y"]}, False),  # a disk that was replaced
        ({"network": ["c"], "disk": ["y"]}, True),
        ({"network": ["c"], "disk": ["x"]}, True),  # cheap disks have one serial number
        ({"disk": ["x"]}, False),
        ({"disk": ["y"]}, True),
        ({"board": ["z"]}, False),  # nothing to compare
        ({}, False),
    ],
    ids=str,
)
def test_pcs_differ_by_their_cards_or_without_cards_by_their_disks(
    other: dict[str, list[str]], is_other: bool
) -> None:
    assert is_other_hardware(ONE, other) == is_other
    assert is_other_hardware(other, ONE) == is_other
