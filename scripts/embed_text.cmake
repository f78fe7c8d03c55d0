# Makes a C++ source of a text file, so that a program carries it in itself:
#
#     cmake -DTEXT=FILE -DSOURCE=FILE -DHEADER=presets.h -DFUNCTION=name -P embed_text.cmake
#
# The source defines `std::string_view ripstop::name()`, which the header declares. The text must not
# contain the characters )text" in this order.
file(READ "${TEXT}" text)
file(WRITE "${SOURCE}" "#include \"${HEADER}\"

std::string_view ripstop::${FUNCTION}()
{
    return R\"text(${text})text\";
}
")
