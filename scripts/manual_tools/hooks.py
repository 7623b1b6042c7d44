"""Settings of mkdocs that its configuration file cannot express."""

import re


def slug(text, separator):
    """A heading's anchor, as Git hosts make it, so that the same links work there and in the site."""
    words = re.sub(r"[^\w\s-]", "", text.strip().lower())
    return re.sub(r"\s", separator, words)


def on_config(config):
    config["mdx_configs"].setdefault("toc", {})["slugify"] = slug
    return config
