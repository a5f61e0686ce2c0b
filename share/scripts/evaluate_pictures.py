"""Pictures for the docs: each below 300 kB."""
import pathlib

PICTURES = pathlib.Path("docs/pictures")
LARGEST_B = 300_000


def keep(source, name):
    """As docs/pictures/evaluation-NAME.png, with as few colours, then pixels, as the size asks for."""
    from PIL import Image  # only here: the tests of the tables do without

    target = PICTURES / f"evaluation-{name}.png"
    target.parent.mkdir(parents=True, exist_ok=True)
    picture = Image.open(source).convert("RGB")
    for colours, scale in ((96, 1), (48, 1), (48, 0.75), (32, 0.5)):
        size = (round(picture.width * scale), round(picture.height * scale))
        small = picture.resize(size, Image.LANCZOS) if scale < 1 else picture
        small.quantize(colours).save(target, optimize=True)
        if target.stat().st_size <= LARGEST_B:
            return
    raise SystemExit(f"evaluate: {target} is larger than {LARGEST_B} bytes whatever is tried")
